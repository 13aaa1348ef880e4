"""`raybundle calibration`: convert, compare, and the library, as they are typed."""

import json
import re

import numpy as np
import pytest
from PIL import Image
from tests.cli.reported import codes_of, refusal, reported, values_of
from tests.messages import refused

from raybundle import adjust
from raybundle.block.frames import stored_turned
from raybundle.cli.calibration import command
from raybundle.cli.main import main
from raybundle.errors import InputError
from raybundle.io.cameras.library import read_library
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, brown_camera, field_scene
from raybundle.report.write import write_result
from raybundle.words import headline

TEXT = """[cameras.left]
model = "brown"
width_px = 600
height_px = 400
pixel_mm = [0.04, 0.04]
c_mm = 28.0
x0_mm = 0.1
K1 = 3e-5
P1 = 2e-6
"""


def run(*words):
    return command.main([str(w) for w in words], standalone_mode=False)


@pytest.fixture
def ours(tmp_path):
    (tmp_path / "ours.toml").write_text(TEXT)
    return tmp_path / "ours.toml"


def values(capsys, *words):
    """Values of what a command reports, by code."""
    return values_of(reported(capsys, "calibration", *words))


def difference(capsys, first, second, distance=None):
    """The line in which two calibrations are compared, by the figures of --json."""
    run("compare", first, second, "--json", *(() if distance is None else ("--object-distance", distance)))
    table = json.loads(capsys.readouterr().out)
    return headline("calibration.difference", {
        "infinity": distance is None, "distance": distance, "rms_px": table["rms_px"],
        "largest_px": table["largest_px"], "turn_deg": float(np.degrees(np.linalg.norm(table["rotation_rad"]))),
    })  # fmt: skip


def exif_photo(path, focal=28.0, size=(600, 400)):
    exif = Image.Exif()
    exif[271], exif[272] = "Maker", "Model One"
    exif.get_ifd(0x8769)[37386] = focal
    pixels = np.random.default_rng(1).integers(0, 255, (size[1], size[0], 3), np.uint8)
    Image.fromarray(pixels).save(path, exif=exif)
    return path


def test_convert_says_what_the_fit_leaves(ours, tmp_path, capsys):
    found = values(capsys, "convert", ours, "--to", "opencv", "--model", "5", "--out", tmp_path / "c.yaml")
    camera = found["calibration.converted"]
    assert (camera["camera"], camera["model"], camera["exact"]) == ("left", "5", False)
    assert 0 < camera["rms_px"] <= camera["largest_px"]
    assert "calibration.validity" in found
    found = values(capsys, "convert", tmp_path / "c.yaml", "--to", "colmap", "--out", tmp_path / "cameras.txt")
    assert found["calibration.converted"]["model"] == "FULL_OPENCV"
    assert found["calibration.converted"]["exact"]
    run("convert", tmp_path / "c.yaml", "--to", "raybundle", "--pixel-mm", "0.04", "--out", tmp_path / "again.toml")
    run("compare", ours, tmp_path / "again.toml", "--json")
    lines = capsys.readouterr().out.strip().splitlines()
    assert json.loads(lines[-1])["largest_px"] < 0.05


def test_what_is_off_is_not_written_unless_asked_for(tmp_path, capsys):
    wide = tmp_path / "wide.toml"
    wide.write_text(
        '[cameras.wide]\nmodel = "rational"\nwidth_px = 6000\nheight_px = 4000\npixel_mm = [0.006, 0.006]\n'
        "c_mm = 16.0\n"
        "k1 = 0.3\nk2 = 0.05\nk3 = 0.001\nk4 = 0.5\nk5 = 0.09\nk6 = 0.003\nestimate = []\n"
    )
    found = values(capsys, "convert", wide, "--to", "opencv", "--out", tmp_path / "c.yaml")["calibration.converted"]
    assert (found["camera"], found["model"], found["exact"]) == ("wide", "8", True)
    arguments = [
        "calibration",
        "convert",
        str(wide),
        "--to",
        "opencv",
        "--model",
        "4",
        "--out",
        str(tmp_path / "d.yaml"),
    ]
    assert refusal(capsys, *arguments)[0] == "calibration.deviation"
    assert not (tmp_path / "d.yaml").exists()
    assert main([*arguments, "--approximate"]) == 0
    assert (tmp_path / "d.yaml").exists()


def test_compare_prints_the_map(ours, tmp_path, capsys):
    (tmp_path / "b.toml").write_text(TEXT.replace("K1 = 3e-5", "K1 = 4e-5"))
    run("compare", ours, tmp_path / "b.toml")
    printed = capsys.readouterr().out
    assert printed.splitlines()[0] == difference(capsys, ours, tmp_path / "b.toml")
    rows = [[float(v) for v in line.split()] for line in printed.splitlines()[-3:]]
    assert np.shape(rows) == (3, 3)
    assert rows[0][0] > rows[1][1] > 0
    run("compare", ours, tmp_path / "b.toml", "--object-distance", "5")
    assert capsys.readouterr().out.splitlines()[0] == difference(capsys, ours, tmp_path / "b.toml", distance=5.0)
    (tmp_path / "half.toml").write_text(
        TEXT.replace("600", "300").replace("400", "200").replace("[0.04, 0.04]", "[0.08, 0.08]")
    )
    run("compare", ours, tmp_path / "half.toml")
    printed = capsys.readouterr().out
    assert float(printed.split("rms ")[1].split()[0]) < 1e-6
    assert "covariances" not in printed  # none is known
    run("compare", ours, tmp_path / "half.toml", "--verbose")
    assert "300 x 200 px" in capsys.readouterr().out
    (tmp_path / "crop.toml").write_text(TEXT.replace("400", "300"))
    with pytest.raises(InputError, match=r"calibration\.cropped_format"):
        run("compare", ours, tmp_path / "crop.toml")


def test_photographs_stored_upside_down_get_a_camera_of_their_own(tmp_path, capsys):
    camera = brown_camera(size_px=(600, 400), pixel_mm=0.04)
    scene = field_scene(TargetField(camera=camera, stations=4, frontal=1, rows=4, columns=5))
    block = simulate(scene, Survey()).observed
    block = stored_turned(block, np.array([1, 2]), 180)
    write_result(adjust(block), tmp_path / "result")
    words = ("convert", tmp_path / "result", "--to", "opencv", "--out", tmp_path / "c.yaml", "--approximate")
    stored = values_of(reported(capsys, "calibration", *words))["calibration_remark.of_stored"]
    assert stored["turned_deg"] == 180
    assert stored["images"] == [block.images.ids[1], block.images.ids[2]]
    (other,) = tmp_path.glob("c-*turned180.yaml")

    def principal_point(path):
        found = re.search(r"data: \[\s*[^,]+,[^,]+,([^,]+),[^,]+,[^,]+,([^,]+),", path.read_text())
        return np.array([float(found[1]), float(found[2])])

    # a turn by 180 degrees takes x to the width less x; OpenCV counts from the centre of the first pixel
    both = principal_point(tmp_path / "c.yaml") + principal_point(other)
    assert both == pytest.approx(np.array([599.0, 399.0]), abs=0.5)
    assert principal_point(other) != pytest.approx(np.array([299.5, 199.5]), abs=1e-3)
    run("convert", tmp_path / "result", "--to", "colmap", "--out", tmp_path / "cameras.txt", "--approximate")
    assert len([x for x in (tmp_path / "cameras.txt").read_text().splitlines() if not x.startswith("#")]) == 2


def test_a_result_is_kept_with_its_covariance_and_found(tmp_path, capsys):
    field = TargetField(
        camera=brown_camera(size_px=(600, 400), pixel_mm=0.04), stations=4, frontal=1, rows=4, columns=5
    )
    result = adjust(simulate(field_scene(field), Survey()).observed)
    write_result(result, tmp_path / "result")
    camera = result.adjusted.cameras[0]
    taken = exif_photo(tmp_path / "a.jpg")
    library = tmp_path / "library"
    run("add", tmp_path / "result", "--photo", taken, "--library", library)
    assert "Model One" in capsys.readouterr().out
    (entry,) = read_library(library).entries
    assert entry.camera.values == pytest.approx(dict(camera.values), rel=1e-12)
    expected = result.precision.interior[camera.id]
    assert entry.free == result.interior[0].free
    np.testing.assert_allclose(np.diag(entry.covariance), np.diag(expected), rtol=1e-6)
    scale = np.sqrt(np.outer(np.diag(expected), np.diag(expected)))
    np.testing.assert_allclose(entry.covariance / scale, expected / scale, atol=1e-5)
    assert entry.sigma0 == pytest.approx(result.sigma0)
    assert entry.photographs == len(result.adjusted.images)
    run("list", "--library", library)
    assert "1 calibration in" in capsys.readouterr().out
    assert run("find", taken, "--out", tmp_path / "best.toml", "--library", library) == 0
    printed = capsys.readouterr().out
    assert "maker-model-one-28mm-600x400: " in printed
    assert printed.splitlines()[1].startswith("fits")
    run("compare", tmp_path / "best.toml", tmp_path / "result")
    compared = capsys.readouterr().out.splitlines()
    run("compare", tmp_path / "best.toml", tmp_path / "result", "--json")
    table = json.loads(capsys.readouterr().out)
    ratio = table["rms_px"] / table["expected_rms_px"]
    assert ratio < 2
    expected = {"expected_px": table["expected_rms_px"], "ratio": ratio, "same": True}
    assert compared[1] == headline("calibration.expected", expected)
    other = exif_photo(tmp_path / "b.jpg", focal=35.0)
    found = reported(capsys, "calibration", "find", other, "--library", library, status=2)
    assert codes_of(found, ["warnings"]) == ["calibration.none_fits"]
    assert [m["fits"] for m in found["matches"]] == [False]
    assert "35 mm" in found["lines"][0]


def test_add_by_words_and_its_refusals(ours, tmp_path, capsys):
    library = tmp_path / "library"
    with pytest.raises(InputError, match=r"library\.no_key"):
        run("add", ours, "--library", library)
    run(
        "add",
        ours,
        "--camera-make",
        "Maker",
        "--camera-model",
        "One",
        "--focal",
        28,
        "--date",
        "2026-05-01",
        "--library",
        library,
    )
    capsys.readouterr()
    run("list", "--json", "--library", library)
    table = json.loads(capsys.readouterr().out)
    assert (table[0]["model"], table[0]["date"], table[0]["source"]) == ("One", "2026-05-01", "ours.toml")
    sizes = {"width_px": 300, "height_px": 200, "camera_width_px": 600, "camera_height_px": 400}
    with refused("photograph.size_of_calibration", **sizes):
        run("add", ours, "--photo", exif_photo(tmp_path / "s.jpg", size=(300, 200)), "--library", library)


def test_several_cameras_in_a_file(ours, tmp_path):
    (tmp_path / "two.toml").write_text(TEXT + TEXT.replace("left", "right"))
    with pytest.raises(InputError, match=r"2.*calibration\.one_camera"):
        run("convert", tmp_path / "two.toml", "--to", "opencv", "--out", tmp_path / "c.yaml")
    run("convert", tmp_path / "two.toml", "--camera", "right", "--to", "opencv", "--out", tmp_path / "c.yaml")
    run("convert", tmp_path / "two.toml", "--to", "kalibr", "--out", tmp_path / "chain.yaml")
    assert "cam1:" in (tmp_path / "chain.yaml").read_text()
    with refused("camera.unknown", camera="up", known=["left", "right"]):
        run("convert", tmp_path / "two.toml", "--camera", "up", "--to", "opencv", "--out", tmp_path / "d.yaml")


def test_errors_leave_by_the_exit_status(tmp_path, capsys):
    assert main(["calibration", "convert", str(tmp_path / "no.yaml"), "--to", "opencv", "--out", "x.yaml"]) == 2
    assert "[file.missing]" in capsys.readouterr().err


def result_with(grade, folder):
    """A result folder of a simulated calibration with this verdict in it."""
    field = TargetField(
        camera=brown_camera(size_px=(600, 400), pixel_mm=0.04), stations=4, frontal=1, rows=4, columns=5
    )
    result = adjust(simulate(field_scene(field), Survey()).observed)
    camera = result.adjusted.cameras[0].id
    write_result(result, folder, additions={"calibration": {camera: {"grade": grade, "photographs": 3}}})
    return folder


def test_the_verdict_goes_into_the_library_or_keeps_out_of_it(tmp_path, capsys):
    library = tmp_path / "library"
    key = ("--camera-make", "Maker", "--camera-model", "One", "--focal", 28, "--library", library)
    run("add", result_with("weak", tmp_path / "weak"), *key)
    (entry,) = read_library(library).entries
    assert (entry.grade, entry.photographs) == ("weak", 3)
    run("list", "--library", library)
    assert ", weak" in capsys.readouterr().out
    with pytest.raises(InputError, match=r"library\.not_determinable"):
        run("add", result_with("not determinable", tmp_path / "nothing"), *key)
    assert len(read_library(library).entries) == 1
