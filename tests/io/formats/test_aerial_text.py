"""PAT-B and BINGO: written by hand from the description of the format, control and roles, both readings, bad input."""

from dataclasses import replace

import numpy as np
import pytest
from click.testing import CliRunner
from tests.messages import coded

from raybundle.block import Role
from raybundle.cli.convert import command
from raybundle.errors import InputError
from raybundle.io.block.folder import read_block, write_block
from raybundle.io.formats import Export, read_format, write_format
from raybundle.numerics.rotation import rotation_from_angles
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, aerial_scene, brown_camera

BOTH = ("patb", "bingo")
# two photographs 1000 m above three points, c 150 mm, without turns: x = 150 mm * dX / 1000 m
IMAGES_PATB = """\
 1001 150000.0
   11 15000.0 30000.0 1
   12 0.0 -15000.0 1
 -99
 1002 150000.0
   11 -15000.0 30000.0
   12 -30000.0 -15000.0
   13 0 0
 -99
"""
ORIENTATIONS = """\
            1001                        1000.00000      2000.00000      1000.00000
  1.000000000000  0.000000000000  0.000000000000  0.000000000000  1.000000000000
  0.000000000000  0.000000000000  0.000000000000  1.000000000000
            1002                        1200.00000      2000.00000      1000.00000
  1.000000000000  0.000000000000  0.000000000000  0.000000000000  1.000000000000
  0.000000000000  0.000000000000  0.000000000000  1.000000000000
"""
CONTROL = "11 1100.0 2200.0 0.0 1 1\n12 1000.0 1900.0 0.0 1 0\n-99\n"
PATB = {"b.im": IMAGES_PATB, "b.ori": ORIENTATIONS, "b.con": CONTROL}
BINGO = {
    "image.dat": ("1001 RMK\n11 15.0 30.0\n12 0.0 -15.0\n\n1002 RMK\n11 -15.0 30.0\n12 -30.0 -15.0\n13 0.0 0.0\n-99\n"),
    "itera.dat": "ORIA 1001 1000 2000 1000 0 0 0\nORIA 1002 1200 2000 1000 0 0 0\nCOOR 13 1200 2000 0\n",
    "geoin.dat": "# control\nCONT 11 1100 2200 0 0.05 0.05 0.1\nCONP 12 1000 1900 0.05 0.05\n",
    "cameras.toml": (
        '[cameras.RMK]\nmodel = "brown"\nwidth_px = 9200\nheight_px = 9200\npixel_mm = [0.025, 0.025]\nc_mm = 150.0\n'
        "estimate = []\n"
    ),
}


def folder(path, files):
    path.mkdir()
    for name, text in files.items():
        (path / name).write_text(text)
    return path


@pytest.mark.parametrize(("name", "files"), [("patb", PATB), ("bingo", BINGO)], ids=BOTH)
def test_a_folder_by_hand(name, files, tmp_path):
    read = read_format(name, folder(tmp_path / "b", files))
    block = read.block
    assert block.images.ids == ("1001", "1002")
    np.testing.assert_allclose(block.images.centre, [[1000, 2000, 1000], [1200, 2000, 1000]])
    np.testing.assert_allclose(block.images.rotation, np.tile(np.eye(3), (2, 1, 1)), atol=1e-12)
    camera = block.cameras[0]
    assert camera.values["c"] == 150
    place = {p: k for k, p in enumerate(block.points.ids)}
    o = block.observations
    assert len(o) == 5
    # the image point of 11 in 1001 by hand: 15 mm right, 30 mm up
    row = next(k for k in range(5) if o.image[k] == 0 and o.point[k] == place["11"])
    np.testing.assert_allclose(camera.image_from_pixel(o.xy_px[row]), [15, 30], atol=1e-9)
    np.testing.assert_allclose(block.points.xyz[place["11"]], [1100, 2200, 0])
    assert block.points.role[place["11"]] == block.points.role[place["12"]] == Role.CONTROL
    assert np.isnan(block.points.xyz[place["12"], 2])  # control in plan alone
    if name == "bingo":
        np.testing.assert_allclose(
            block.points.sigma[[place["11"], place["12"]]], [[0.05, 0.05, 0.1], [0.05, 0.05, np.nan]]
        )
        assert not any(r.code == "import.control_sigma_assumed" for r in read.remarks)
    else:
        [assumed] = [r for r in read.remarks if r.code == "import.control_sigma_assumed"]
        assert assumed.values["plan_m"] == 0.01
        assert any(r.code == "import.format_assumed" for r in read.remarks)


# sin phi = 3/5, sin omega = 5/13, kappa a right angle:
#   R2(phi) = [4 0 -3; 0 5 0; 3 0 4] / 5,  R1(omega) = [13 0 0; 0 12 5; 0 -5 12] / 13
#   R3(kappa) = [0 1 0; -1 0 0; 0 0 1]
#   R3 R1 R2 = [15 60 20; -52 0 39; 36 -25 48] / 65
# (U, V, W) = (65, 130, -650) m in the image's axes is R' (U, V, W) = (-449, 310, -382) m in the object's, and
# x = -c U / W = 15 mm, y = -c V / W = 30 mm with c = 150 mm; the others alike
TURNED = np.array([[15, 60, 20], [-52, 0, 39], [36, -25, 48]]) / 65
BY_HAND = {
    "11": ("15.0 30.0", (-449, 310, -382)),
    "12": ("0.0 0.0", (-360, 250, -480)),
    "13": ("15.0 -15.0", (-293, 310, -499)),
    "14": ("-30.0 15.0", (-442, 130, -481)),
}
TURNED_PATB = {
    "b.im": " 7 150000.0\n" + "".join(
        f" {p} {' '.join(str(1000 * float(v)) for v in xy.split())}\n" for p, (xy, _) in BY_HAND.items()
    ) + " -99\n",
    "b.ori": (
        "               7                      1000.00000      2000.00000       900.00000\n"
        "  0.230769230769 -0.800000000000  0.553846153846  0.923076923077  0.000000000000\n"
        " -0.384615384615  0.307692307692  0.600000000000  0.738461538462\n"
    ),
    "b.con": "".join(f"{p} {1000 + X} {2000 + Y} {900 + Z} 1 1\n" for p, (_, (X, Y, Z)) in BY_HAND.items()) + "-99\n",
}  # fmt: skip
TURNED_BINGO = {
    "image.dat": "7 RMK\n" + "".join(f"{p} {xy}\n" for p, (xy, _) in BY_HAND.items()) + "-99\n",
    "itera.dat": "ORIA 7 1000 2000 900 40.966552940 25.133183244 100.0\n",
    "geoin.dat": "".join(
        f"CONT {p} {1000 + X} {2000 + Y} {900 + Z} 0.1 0.1 0.1\n" for p, (_, (X, Y, Z)) in BY_HAND.items()
    ),
    "cameras.toml": BINGO["cameras.toml"],
}


@pytest.mark.parametrize(("name", "files"), [("patb", TURNED_PATB), ("bingo", TURNED_BINGO)], ids=BOTH)
def test_turns_by_hand(name, files, tmp_path):
    """Both ways: what is read is the matrix worked out above, and what is written from it are the same numbers."""
    read = read_format(name, folder(tmp_path / "b", files))
    assert not any(r.code == "import.orientation_convention" for r in read.remarks)
    block = read.block
    np.testing.assert_allclose(block.images.rotation[0], TURNED, atol=1e-9)
    # and the image points fit: every one is where the condition puts it
    o = block.observations
    image = block.cameras[0].image_from_pixel(o.xy_px)
    U, V, W = TURNED @ (block.points.xyz[o.point] - block.images.centre[0]).T
    np.testing.assert_allclose(image, -150 * np.stack([U, V], axis=1) / W[:, None], atol=1e-9)
    write_format(name, Export(block=block), tmp_path / "out")
    if name == "bingo":
        (line,) = [r for r in (tmp_path / "out/itera.dat").read_text().splitlines() if r.startswith("ORIA")]
        np.testing.assert_allclose([float(w) for w in line.split()[-3:]], [40.966552940, 25.133183244, 100], atol=1e-8)
    else:
        _, *elements = (tmp_path / "out/block.ori").read_text().splitlines()
        numbers = [float(w) for row in elements for w in row.split()]
        np.testing.assert_allclose(numbers, [float(w) for w in files["b.ori"].split()[4:]], atol=1e-11)


def flight(**camera):
    survey = Survey(control=3, check=2, control_sigma=(0.02, 0.02, 0.04), check_sigma=0.03)
    plan = AerialStrips(camera=brown_camera(values=camera), strips=2, images_per_strip=3, points_per_image=12)
    return simulate(aerial_scene(plan), survey).truth


@pytest.mark.parametrize("name", BOTH)
def test_roles_control_and_names_come_back(name, tmp_path):
    block = flight()
    names = tuple(f"Kirche {k}" for k in range(len(block.points)))
    block = replace(
        block,
        points=replace(block.points, ids=names),
        images=replace(block.images, file=tuple(f"strip 1/{k}.tif" for k in range(len(block.images)))),
    )
    write_format(name, Export(block=block), tmp_path / "b")
    again = read_format(name, tmp_path / "b").block
    assert again.points.ids == names
    assert again.images.ids == block.images.file
    np.testing.assert_array_equal(again.points.role, block.points.role)
    given = np.asarray(block.points.role) != Role.TIE
    np.testing.assert_allclose(again.points.sigma[given], block.points.sigma[given])
    np.testing.assert_allclose(again.points.xyz, block.points.xyz, atol=1e-9)
    assert again.cameras[0].values == block.cameras[0].values


def without_own(path):
    for name in ("cameras.toml", "raybundle-images.csv", "raybundle-points.csv"):
        (path / name).unlink()


def distortion_free():
    return flight(**dict.fromkeys(("x0", "y0", "K1", "K2", "K3", "P1", "P2"), 0.0))


def test_patb_stands_without_our_own_files(tmp_path):
    block = distortion_free()
    write_format("patb", Export(block=block), tmp_path / "b")
    without_own(tmp_path / "b")
    again = read_format("patb", tmp_path / "b").block
    assert again.cameras[0].values["c"] == pytest.approx(block.cameras[0].values["c"])
    np.testing.assert_allclose(again.images.centre, block.images.centre, atol=1e-9)
    mine = block.cameras[0].image_from_pixel(block.observations.xy_px)
    np.testing.assert_allclose(again.cameras[0].image_from_pixel(again.observations.xy_px), mine, atol=1e-8)


def test_the_transpose_is_recognised_by_the_image_points(tmp_path):
    block = distortion_free()
    write_format("patb", Export(block=block), tmp_path / "b")
    path = tmp_path / "b/block.ori"
    words = path.read_text().split()
    lines = []
    for k in range(0, len(words), 13):
        D = np.array(words[k + 4 : k + 13], float).reshape(3, 3).T.ravel()
        lines += [" ".join(words[k : k + 4]), " ".join(map(repr, D[:5].tolist())), " ".join(map(repr, D[5:].tolist()))]
    path.write_text("\n".join(lines))
    read = read_format("patb", tmp_path / "b")
    assert any(r.values.get("reading") == "object_to_image" for r in read.remarks)
    np.testing.assert_allclose(read.block.images.rotation, block.images.rotation, atol=1e-9)


@pytest.mark.parametrize(("unit", "reading"), [(200 / np.pi, "opk_gon"), (180 / np.pi, "opk_deg")])
def test_other_angles_are_recognised_by_the_image_points(unit, reading, tmp_path):
    block = distortion_free()
    turned = rotation_from_angles(np.array([0.3, 0.25, 0.0])) @ block.images.rotation  # strong tilts tell the order
    block = replace(block, images=replace(block.images, rotation=turned))
    block = reprojected(block)
    write_format("bingo", Export(block=block), tmp_path / "b")
    path = tmp_path / "b/itera.dat"
    lines = [line for line in path.read_text().splitlines() if line.startswith("COOR")]
    for k in range(len(block.images)):
        X0, angles = block.images.centre[k].tolist(), (block.images.angles[k] * unit).tolist()
        lines.append(f"ORIA {block.images.ids[k]} " + " ".join(map(repr, [*X0, *angles])))
    path.write_text("\n".join(lines))
    read = read_format("bingo", tmp_path / "b")
    assert any(r.values.get("reading") == reading for r in read.remarks)
    np.testing.assert_allclose(read.block.images.rotation, block.images.rotation, atol=1e-9)


def reprojected(block):
    """Image points of the turned photographs, within the format or not."""
    o, c = block.observations, block.cameras[0]
    local = np.einsum(
        "nij,nj->ni", block.images.rotation[o.image], block.points.xyz[o.point] - block.images.centre[o.image]
    )
    image = -c.values["c"] * local[:, :2] / local[:, 2:]
    return replace(block, observations=replace(o, xy_px=c.pixel_from_image(image)))


def test_the_command_converts_there_and_back(tmp_path):
    write_block(flight(), tmp_path / "flight")
    for name in BOTH:
        for words in (
            [tmp_path / "flight", "--to", name, "--out", tmp_path / name],
            [tmp_path / name, "--from", name, "--to", "block", "--out", tmp_path / f"{name}-again"],
        ):
            result = CliRunner().invoke(command, [str(w) for w in words])
            assert result.exit_code == 0, result.exception
        again = read_block(tmp_path / f"{name}-again")
        assert len(again.observations) == len(flight().observations)


@pytest.mark.parametrize(
    ("name", "file", "old", "new", "words"),
    [
        ("patb", "b.im", "150000.0\n   11", "c\n   11", r"b\.im.*1.*value\.not_finite"),
        ("patb", "b.im", "15000.0 30000.0 1", "15000.0", r"b\.im.*2.*patb\.image_point_line"),
        (
            "patb", "b.im", " -99\n 1002", " 1002", r"b\.im.*4.*99.*patb\.image_point_line"
        ),
        ("patb", "b.im", "13 0 0\n -99", "13 0 0", r"1002.*99.*patb\.photograph_not_closed"),
        ("patb", "b.im", "1002", "1001", r"1001.*name\.twice"),
        ("patb", "b.im", "13 0 0", "13 9e9 0", r"8.*9.*0.*image_point\.out_of_range"),
        ("patb", "b.ori", "  1.000000000000  0.0", "  1.100000000000  0.0", r"b\.ori.*1.*rotation\.not_orthogonal"),
        (
            "patb", "b.ori", "0  1.000000000000\n            1002", "0\n            1002",
            r"3.*4.*line\.too_few_words"
        ),
        ("patb", "b.con", "12 1000", "11 1000", r"b\.con.*2.*11.*name\.twice"),
        ("bingo", "image.dat", "1001 RMK\n", "", r"image\.dat.*1.*bingo\.point_before_photograph"),
        ("bingo", "image.dat", "30.0\n12", "nan\n12", r"2.*value\.not_finite"),
        ("bingo", "image.dat", "1001 RMK", "1001 WILD", r"1.*cameras\.toml.*reference\.unknown"),
        ("bingo", "itera.dat", "1000 0 0 0\nORIA", "1000 0 0\nORIA", r"itera\.dat.*1.*7.*8.*line\.too_few_words"),
        ("bingo", "itera.dat", "COOR 13", "COOR", r"itera\.dat.*3.*4.*5.*line\.too_few_words"),
        ("bingo", "geoin.dat", "CONP 12", "CONP 11", r"geoin\.dat.*3.*11.*name\.twice"),
        ("bingo", "geoin.dat", "0.05 0.1", "0.05 -0.1", r"geoin\.dat.*2.*cell\.negative_sigma"),
        ("bingo", "cameras.toml", "c_mm = 150.0", "c_mm = 0.0", "cameras.toml"),
    ],
)  # fmt: skip
def test_bad_files_are_named(name, file, old, new, words, tmp_path):
    files = dict(PATB if name == "patb" else BINGO)
    if "WILD" in new:  # a second camera, so that the one is not taken for all
        files["cameras.toml"] += files["cameras.toml"].replace("RMK", "RC")
    assert old in files[file]
    files[file] = files[file].replace(old, new, 1)
    with pytest.raises(InputError, match=words):
        read_format(name, folder(tmp_path / "b", files))


def test_what_does_not_fit_is_refused(tmp_path):
    with pytest.raises(InputError, match=r"camera\.constant_unknown"):
        read_format("bingo", folder(tmp_path / "b", {k: v for k, v in BINGO.items() if k != "cameras.toml"}))
    with pytest.raises(InputError, match=r"NAME\.im.*folder\.file_missing"):
        read_format("patb", folder(tmp_path / "c", {}))
    with pytest.raises(InputError, match=r"2.*folder\.several_files"):
        read_format("patb", folder(tmp_path / "d", {**PATB, "c.im": IMAGES_PATB}))


@pytest.mark.parametrize("name", BOTH)
def test_a_block_in_millimetres_is_written_in_metres(name, tmp_path):
    metres = flight()
    millimetres = replace(
        metres,
        length_unit="mm",
        images=replace(metres.images, centre=metres.images.centre * 1000),
        points=replace(metres.points, xyz=metres.points.xyz * 1000, sigma=metres.points.sigma * 1000),
    )
    written = write_format(name, Export(block=millimetres), tmp_path / "mm")
    assert coded(written.remarks)["conversion.in_metres"]["unit"] == "mm"
    plain = write_format(name, Export(block=metres), tmp_path / "m")
    assert "conversion.in_metres" not in coded(plain.remarks)
    a, b = (read_format(name, tmp_path / n).block for n in ("mm", "m"))
    assert a.length_unit == "m"
    np.testing.assert_allclose(a.images.centre, metres.images.centre, atol=1e-6)
    np.testing.assert_allclose(a.points.xyz, b.points.xyz, atol=1e-6)
    np.testing.assert_allclose(a.points.sigma, b.points.sigma, rtol=1e-6)
    np.testing.assert_allclose(a.observations.xy_px, b.observations.xy_px, atol=1e-4)
