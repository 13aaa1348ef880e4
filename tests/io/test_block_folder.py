"""Block folders: strict reading, exact writing, errors that name file, line and column."""

import os
import random
import shutil
import time
from dataclasses import fields, is_dataclass, replace
from pathlib import Path

import numpy as np
import pytest
from tests.block.any_blocks import always_as_by_default
from tests.messages import refused

from raybundle.block import Block, Instrument, PixelFrame, Relation, Role
from raybundle.errors import InputError, UnknownSensorModel
from raybundle.io.block.folder import read_block, write_block
from raybundle.observations import tables
from raybundle.observations.parameter import Calibrated
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import SinglePhoto, TargetField, field_scene, single_scene

DATA = Path(os.environ.get("RAYBUNDLE_DATA", Path(__file__).parents[3] / "shared" / "data")) / "blocks"
BLOCKS = sorted(p.name for p in DATA.iterdir() if p.is_dir()) if DATA.is_dir() else []

TOML = """\
name = "small"
length_unit = "m"

[cameras.1]
model = "brown"
width_px = 4000
height_px = 3000
pixel_mm = [0.005, 0.005]
c_mm = 24.0
K1 = 1e-5
estimate = ["c", "K1"]
sigma = {c = 0.05}
"""
IMAGES = """\
image,camera,file,X,Y,Z,omega_deg,phi_deg,kappa_deg
a,1,a.jpg,0,0,10,0,0,0
b,1,,,,,,,
"""
OBSERVATIONS = """\
image,point,x_px,y_px,sx_px,sy_px,sxy_px2
a,p1,2000,1500,0.1,0.1,
a,p2,2500.5,1400.25,0.1,0.2,0.01
b,p1,1900,1500,0.1,0.1,
b,new,1950,1600,0.1,0.1,
"""
POINTS = """\
point,role,X,Y,Z,sX,sY,sZ
p1,control,1,2,3,0,0.01,
p2,check,1,2,3,,,
p3,tie,,,,,,
"""
DISTANCES = "from,to,length,sigma\np1,p2,1.5,0.001\n"
STATIONS = "image,X,Y,Z,sX,sY,sZ\na,0,0,10,0.05,0.05,\n"
SMALL = {
    "block.toml": TOML,
    "images.csv": IMAGES,
    "observations.csv": OBSERVATIONS,
    "points.csv": POINTS,
    "distances.csv": DISTANCES,
    "stations.csv": STATIONS.replace(",10,", ",,"),
}


@pytest.fixture
def small(tmp_path):
    folder = tmp_path / "small"
    folder.mkdir()
    for name, text in SMALL.items():
        (folder / name).write_text(text, encoding="utf-8")
    return folder


def assert_same(a, b, where="block", *, angles=1e-13):
    """Equal to the last bit; rotation matrices, which are written as angles, to `angles`."""
    assert type(a) is type(b), where
    if is_dataclass(a):
        for f in fields(a):
            assert_same(getattr(a, f.name), getattr(b, f.name), f"{where}.{f.name}", angles=angles)
    elif isinstance(a, np.ndarray):
        assert a.dtype == b.dtype, where
        if where.endswith("rotation"):
            np.testing.assert_allclose(a, b, rtol=0, atol=angles)
        else:
            np.testing.assert_array_equal(a, b, err_msg=where)
    elif isinstance(a, tuple):
        assert len(a) == len(b), where
        for k, (x, y) in enumerate(zip(a, b, strict=True)):
            assert_same(x, y, f"{where}[{k}]", angles=angles)
    elif isinstance(a, dict):
        assert a.keys() == b.keys(), where
        for k, x in a.items():
            assert_same(x, b[k], f"{where}[{k}]", angles=angles)
    else:
        assert a == b, where


def test_a_small_block_reads_as_it_is_written_down(small):
    block = read_block(small)
    assert block.name == "small"
    assert block.images.ids == ("a", "b")
    assert block.images.oriented.tolist() == [True, False]
    assert block.points.ids == ("p1", "p2", "p3", "new")
    assert block.points.role.tolist() == [Role.CONTROL, Role.CHECK, Role.TIE, Role.TIE]
    assert block.points.is_control.tolist()[0] == [True, True, False]
    np.testing.assert_array_equal(block.observations.cov_px2[1], [0.1 * 0.1, 0.2 * 0.2, 0.01])
    assert block.cameras[0].values["c"] == 24.0
    assert block.cameras[0].values["K2"] == 0.0
    assert block.cameras[0].sigma == {"c": 0.05}
    assert block.distances.length.tolist() == [1.5]
    assert np.isnan(block.stations.xyz[0, 2])


def test_tables_may_be_left_out(small):
    for name in ("points.csv", "distances.csv", "stations.csv"):
        (small / name).unlink()
    block = read_block(small)
    assert block.points.ids == ("p1", "p2", "new")
    assert len(block.distances) == len(block.stations) == 0


@pytest.mark.data
@pytest.mark.skipif(not BLOCKS, reason="the public data sets are not here; set RAYBUNDLE_DATA")
@pytest.mark.parametrize("name", BLOCKS or ["none"])
def test_public_blocks_read_back_equal(name, tmp_path):
    block = read_block(DATA / name)
    write_block(block, tmp_path / "once")
    again = read_block(tmp_path / "once")
    assert_same(block, again)
    write_block(again, tmp_path / "twice")
    for file in (tmp_path / "once").iterdir():
        assert file.read_bytes() == (tmp_path / "twice" / file.name).read_bytes(), file.name


def rich_block() -> Block:
    """A block with everything that the format knows."""
    survey = Survey(
        control=4, control_sigma=(0.01, 0.02, float("nan")), check=2, scale_bars=2, station_sigma=0.05,
        points="approximate",
    )  # fmt: skip
    block = simulate(field_scene(TargetField(stations=5, frontal=1)), survey).observed
    camera = replace(
        block.cameras[0], id='the "new" one, 2', interior="per_image", sigma={"c": 0.05, "K1": 1e-7},
        estimate=("c", "K1"),
    )  # fmt: skip
    other = replace(
        block.cameras[0], id="other", estimate="auto", per_image=("x0", "y0"),
        relations=(
            Relation(name="smooth", terms={"K1": 2.0, "K2": -1.0}, sigma=0.1, observed=3.0),
            Relation(name="scale", terms={"c": 1.0}, sigma=0.02, observed=3.1, logarithm=True, origin="known before"),
        ),
        calibrated=Calibrated(
            symbols=("c", "K1"), values=(20.1, 1e-5), sigma=(0.01, 1e-7), correlations=((1.0,), (0.25, 1.0))
        ),
    )  # fmt: skip
    antenna = Instrument(id="gnss", model="antenna", values={"az": 0.3}, estimate=("az", "sz"), sigma={"az": 0.01})
    imu = Instrument(id="ins", model="imu", values={"bx": 1e-3}, estimate=("bx", "by", "bz"))
    held = np.zeros(len(block.images), bool)
    held[2] = True
    images = replace(
        block.images,
        ids=("a,b", 'say "x"', *block.images.ids[2:]),
        file=("übung.jpg", "a, b.jpg", *block.images.file[2:]),
        held=held,
        date=tuple(f"2026-05-{1 + k % 2:02d}" for k in range(len(block.images))),
        interior={1: {"c": 20.123456789012345, "K1": -1.2345678901234567e-5}, 3: {"x0": 0.25, "y0": -0.125}},
        camera=np.where(np.arange(len(block.images)) == 3, 1, 0).astype(np.int32),
        frames={0: PixelFrame(turned=180, width_px=camera.width_px // 2, height_px=camera.height_px // 2)},
    )
    cov = block.observations.cov_px2.copy()
    cov[:, 2] = 0.3 * cov[:, 0]
    return replace(
        block, about='two\nlines, a "quote", \\ and \x7f', length_unit="mm", sigma0_apriori=0.1,
        residuals="corrected", licence="CC0", noise="fields", datum_over="good", free_scale=True,
        rejected=((images.ids[0], block.points.ids[0]),), cameras=(camera, other), instruments=(antenna, imu),
        images=images, observations=replace(block.observations, cov_px2=cov),
    )  # fmt: skip


def test_everything_the_format_knows_reads_back_equal(tmp_path):
    block = rich_block()
    nominal = replace(block, free_scale=False, nominal_scale=True)  # one block has one of the two
    of_tables = {f"{t.__name__}.{f.name}" for t in tables.values() for f in fields(t)}  # tests/observations reads them
    # rigs share no parameters of their own; the format says of instruments only what is free or observed
    elsewhere = {f"Instrument.{name}" for name in ("known", "calibrated", "relations")} | {"Images.station"}
    assert always_as_by_default([block, nominal]) - of_tables == elsewhere | {"Camera.known"}
    for given, name in ((block, "b"), (nominal, "nominal")):
        write_block(given, tmp_path / name)
        assert_same(given, read_block(tmp_path / name))


def test_auto_estimate_reads_back(tmp_path):
    block = simulate(single_scene(SinglePhoto()), Survey()).observed
    block = replace(block, cameras=(replace(block.cameras[0], estimate="auto"),))
    write_block(block, tmp_path / "b")
    assert read_block(tmp_path / "b").cameras[0].estimate == "auto"


def test_windows_files_read_like_others(small):
    block = read_block(small)
    for file in small.iterdir():
        file.write_bytes(b"\xef\xbb\xbf" + file.read_bytes().replace(b"\n", b"\r\n") + b"\r\n\r\n")
    assert_same(block, read_block(small))


def test_columns_may_stand_in_any_order_and_cells_be_quoted(small):
    block = read_block(small)
    (small / "distances.csv").write_text('sigma,length,"to",from\n0.001,"1.5",p2,"p1"\n')
    assert_same(block, read_block(small))


def test_an_existing_folder_is_not_overwritten(small):
    before = {f.name: f.read_bytes() for f in small.iterdir()}
    with pytest.raises(InputError, match=r"folder\.exists"):
        write_block(read_block(small), small)
    assert before == {f.name: f.read_bytes() for f in small.iterdir()}


def test_a_failed_write_leaves_nothing(small, tmp_path, monkeypatch):
    block = read_block(small)
    monkeypatch.setattr("raybundle.io.block.folder.write_observations", broken_write)
    target = tmp_path / "new" / "block"
    with pytest.raises(InputError, match=r"file\.not_writable"):
        write_block(block, target)
    assert list(target.parent.iterdir()) == []


def broken_write(*_):
    raise OSError(28, "No space left on device")


CASES = {
    # name: (file, old, new, line, column, words)
    "unknown column": ("observations.csv", "sxy_px2", "sxy", 1, "sxy", r"table\.unknown_column"),
    "missing column": ("images.csv", ",phi_deg", "", 1, "phi_deg", r"phi_deg.*table\.columns_missing"),
    "column twice": ("points.csv", "sX,sY,sZ", "sX,sX,sZ", 1, "sX", r"table\.column_twice"),
    "text in a number": ("observations.csv", "2500.5", "25oo.5", 3, "x_px", r"cell\.not_a_number"),
    "underscore in a number": ("observations.csv", "2500.5", "2_500", 3, "x_px", r"cell\.not_a_number"),
    "foreign digits": ("observations.csv", "2500.5", "٢٥", 3, "x_px", r"cell\.not_a_number"),
    "decimal comma": ("observations.csv", "2500.5", "2500,5", 3, None, r"table\.cell_count"),
    "semicolons": ("stations.csv", "a,0,0,,", "a;0;0;;", 2, None, r"table\.cell_count"),
    "NaN": ("observations.csv", "2500.5", "nan", 3, "x_px", r"value\.not_finite"),
    "infinity": ("points.csv", "p1,control,1", "p1,control,inf", 2, "X", r"value\.not_finite"),
    "too large": ("points.csv", "p1,control,1", "p1,control,1e999", 2, "X", r"18.*value\.too_large"),
    "empty measurement": ("observations.csv", "2500.5", "", 3, "x_px", r"cell\.empty"),
    "negative sigma": ("points.csv", "0,0.01,", "0,-0.01,", 2, "sY", r"-0\.01.*cell\.negative_sigma"),
    "sigma 0 of an image point": ("observations.csv", "0.1,0.2", "0.1,0", 3, "sy_px", r"0.*cell\.not_positive"),
    "impossible covariance": ("observations.csv", ",0.01\n", ",0.02\n", 3, "sxy_px2", r"observation\.covariance"),
    "negative distance": ("distances.csv", "1.5", "-1.5", 2, "length", r"0.*cell\.not_positive"),
    "distance to itself": ("distances.csv", "p1,p2", "p1,p1", 2, "to", r"observation\.same_point"),
    "distance to nothing": ("distances.csv", "p1,p2", "p1,p9", 2, "to", r"p9.*cell\.unknown_id"),
    "unknown camera": ("images.csv", "b,1", "b,2", 3, "camera", r"2.*block\.toml.*cell\.unknown_id"),
    "unknown image": ("observations.csv", "b,p1", "c,p1", 4, "image", r"images\.csv.*cell\.unknown_id"),
    "unknown station": ("stations.csv", "a,0", "c,0", 2, "image", r"images\.csv.*cell\.unknown_id"),
    "image twice": ("images.csv", "b,1", "a,1", 3, "image", r"2.*cell\.id_twice"),
    "point twice": ("points.csv", "p3,", "p1,", 4, "point", r"p1.*2.*cell\.id_twice"),
    "observation twice": ("observations.csv", "a,p2", "a,p1", 3, "point", r"2.*table\.pair_twice"),
    "empty id": ("points.csv", "p3,", ",", 4, "point", r"cell\.no_id"),
    "id with blanks": ("observations.csv", "b,new", "b, new", 5, "point", r"cell\.no_id"),
    "control character": ("points.csv", "p3,", "p\t3,", 4, "point", r"cell\.unprintable"),
    "unknown role": ("points.csv", "tie", "tied", 4, "role", r"value\.not_supported"),
    "sigma without coordinate": (
        "points.csv", "p1,control,1,2,3,0", "p1,control,,2,3,0", 2, "sX", r"point\.sigma_without_coordinate"
    ),
    "tie with sigma": ("points.csv", "p3,tie,,,,,,", "p3,tie,1,,,1,,", 4, "sX", r"point\.tie_with_sigma"),
    "control without sigma": ("points.csv", "3,0,0.01,", "3,,,", 2, "sX", r"point\.control_without_sigma"),
    "check without coordinate": (
        "points.csv", "p2,check,1,2,3", "p2,check,,,", 3, "X", r"point\.check_without_coordinate"
    ),
    "one angle": ("images.csv", "b,1,,,,,,,", "b,1,,,,,1,,", 3, "omega_deg", r"3.*1.*image\.angles_incomplete"),
    "too few cells": ("points.csv", "p3,tie,,,,,,", "p3,tie", 4, None, r"2.*8.*table\.cell_count"),
    "empty line": ("points.csv", "p2,", "\np2,", 3, None, r"table\.empty_line"),
    "empty line first": ("points.csv", "p1,", "\np1,", 2, None, r"table\.empty_line"),
    "open quote": ("points.csv", "p2,check", '"p2,check', 3, None, r"table\.row_unreadable"),
    "not TOML": ("block.toml", 'name = "small"', "name = small", 1, None, r"toml\.invalid"),
    "unknown key": ("block.toml", "length_unit", "lenght_unit", 2, "lenght_unit", r"toml\.unknown_key"),
    "unknown camera key": ("block.toml", "K1 = 1e-5", "K9 = 1e-5", 10, "cameras.1.K9", r"K9.*toml\.unknown_key"),
    "wrong type": ("block.toml", '"small"', "3", 1, "name", r"3.*value\.no_text"),
    "flag for a number": ("block.toml", "c_mm = 24.0", "c_mm = true", 9, "cameras.1.c_mm", r"value\.not_a_number"),
    "NaN in TOML": ("block.toml", "c_mm = 24.0", "c_mm = nan", 9, "cameras.1.c_mm", r"value\.not_finite"),
    "no camera constant": ("block.toml", "c_mm = 24.0\n", "", 4, "cameras.1.c_mm", r"c_mm.*value\.key_missing"),
    "length unit": ("block.toml", '"m"', '"ft"', 2, "length_unit", r"value\.not_supported"),
    "no width": ("block.toml", "width_px = 4000", "width_px = 0", 6, "cameras.1.width_px", r"0.*value\.not_above"),
    "broken width": ("block.toml", "4000", "4000.5", 6, "cameras.1.width_px", r"value\.not_whole"),
    "pixel": ("block.toml", "[0.005, 0.005]", "0.005", 8, "cameras.1.pixel_mm", r"camera\.pixel_size_missing"),
    "pixel sign": ("block.toml", "[0.005, 0.005]", "[0.005, -0.005]", 8, "cameras.1.pixel_mm", r"0.*value\.not_above"),
    "unknown parameter": ("block.toml", '"K1"]', '"K7"]', 11, "cameras.1.estimate", r"K7.*parameter\.unknown"),
    "parameter twice": ("block.toml", '"K1"]', '"c"]', 11, "cameras.1.estimate", r"parameter\.twice"),
    "estimate all": (
        "block.toml", '["c", "K1"]', '"all"', 11, "cameras.1.estimate", r"estimate\.neither_auto_nor_list"
    ),
    "sigma of nothing": ("block.toml", "{c = 0.05}", "{q = 0.05}", 12, "cameras.1.sigma", r"parameter\.unknown"),
    "sigma of a held one": (
        "block.toml", "{c = 0.05}", "{x0 = 0.05}", 12, "cameras.1.sigma", r"x0.*parameter\.sigma_of_fixed"
    ),
    "negative sigma in TOML": (
        "block.toml", "{c = 0.05}", "{c = -1}", 12, "cameras.1.sigma", r"parameter\.sigma_not_positive"
    ),
    "no cameras": ("block.toml", TOML[TOML.index("[cameras") :], "", None, "cameras", r"block\.no_camera"),
}  # fmt: skip


@pytest.mark.parametrize("case", CASES.values(), ids=CASES)
def test_what_is_wrong_is_named(small, case):
    file, old, new, line, column, words = case
    text = (small / file).read_text(encoding="utf-8")
    assert old in text
    (small / file).write_text(text.replace(old, new, 1), encoding="utf-8")
    with pytest.raises(InputError, match=words) as caught:
        read_block(small)
    error = caught.value
    assert error.file is not None
    assert Path(error.file).name == file
    assert (error.line, error.column) == (line, column)
    assert error.exit_status == 2


@pytest.mark.parametrize("file", ["images.csv", "observations.csv", "points.csv", "distances.csv", "stations.csv"])
@pytest.mark.parametrize("keep", [0, 1], ids=["no header", "header only"])
def test_an_empty_table_is_an_error(small, file, keep):
    text = (small / file).read_text()
    (small / file).write_text("".join(text.splitlines(keepends=True)[:keep]))
    with pytest.raises(InputError, match=r"table\.empty" if keep == 0 else r"table\.too_few_rows") as caught:
        read_block(small)
    assert caught.value.file == str(small / file)


@pytest.mark.parametrize("file", ["block.toml", "images.csv", "observations.csv"])
def test_a_missing_file_is_an_error(small, file):
    (small / file).unlink()
    with pytest.raises(InputError, match=r"block\.file_missing|block\.no_block_toml"):
        read_block(small)


def test_wrong_encoding_names_the_line(small):
    (small / "points.csv").write_bytes(POINTS.replace("p3", "Prüf").encode("latin-1"))
    with refused("file.not_utf8", line=4):
        read_block(small)
    (small / "block.toml").write_bytes(TOML.replace("small", "Prüf").encode("latin-1"))
    with refused("file.not_utf8", line=1):
        read_block(small)


def test_unknown_model_lists_the_known(small):
    (small / "block.toml").write_text(TOML.replace("brown", "pinhole"))
    with refused("model.unknown_sensor", UnknownSensorModel, name="pinhole", file="block.toml", line=5) as caught:
        read_block(small)
    assert {"brown", "fisheye"} <= set(caught.value.message.values["known"])


def test_a_misspelt_table_is_not_passed_over(small):
    (small / "points.csv").rename(small / "Point.csv")
    with pytest.raises(InputError, match=r"points\.csv.*block\.file_name"):
        read_block(small)


def test_other_files_in_the_folder_do_not_matter(small):
    (small / "expected.json").write_text("{}")
    (small / "expected_observations.csv").write_text("x\n")
    assert read_block(small).name == "small"


def test_no_folder_and_result_folder(tmp_path):
    with pytest.raises(InputError, match=r"file\.missing"):
        read_block(tmp_path / "nothing")
    (tmp_path / "result.json").write_text("{}")
    with pytest.raises(InputError, match=r"block\.result_folder"):
        read_block(tmp_path)
    with pytest.raises(InputError, match=r"block\.is_a_file"):
        read_block(tmp_path / "result.json")


def test_several_errors_are_listed_together_in_order(small):
    text = OBSERVATIONS.replace("2000", "x").replace("1900", "y").replace("0.2,", "-3,")
    (small / "observations.csv").write_text(text)
    with pytest.raises(InputError) as caught:
        read_block(small)
    places = [caught.value.place, *(d.place for d in caught.value.message.details)]
    assert [(p.line, p.column) for p in places] == [(2, "x_px"), (3, "sy_px"), (4, "x_px")]


INTERIOR = "image,parameter,value\na,c_mm,24.1\na,K1,2e-5\n"


def per_image(folder, text):
    (folder / "block.toml").write_text(TOML + 'interior = "per_image"\n')
    (folder / "interior.csv").write_text(text)


def test_interior_orientation_per_image(small):
    per_image(small, INTERIOR)
    block = read_block(small)
    assert block.cameras[0].interior == "per_image"
    assert block.images.interior == {0: {"c": 24.1, "K1": 2e-5}}


@pytest.mark.parametrize(
    ("text", "column", "words"),
    [
        (INTERIOR.replace("K1", "K9"), "parameter", r"K9.*parameter\.unknown"),
        (INTERIOR.replace("K1", "c_mm"), "parameter", r"parameter\.twice"),
        (INTERIOR.replace("24.1", "24.1\nb,c_mm,-1"), "value", r"0.*value\.not_above"),
        (INTERIOR.replace("a,K1", "z,K1"), "image", r"cell\.unknown_id"),
    ],
)
def test_bad_interior_tables(small, text, column, words):
    per_image(small, text)
    with pytest.raises(InputError, match=words) as caught:
        read_block(small)
    assert (caught.value.line, caught.value.column) == (3, column)


def test_interior_table_needs_per_image(small):
    (small / "interior.csv").write_text(INTERIOR)
    with pytest.raises(InputError, match=r"per_image.*interior\.shared"):
        read_block(small)


def test_held_orientations(small):
    text = (
        IMAGES.replace("kappa_deg", "kappa_deg,held")
        .replace("0,0,0\n", "0,0,0,1\n")
        .replace("b,1,,,,,,,", "b,1,,,,,,,,")
    )
    (small / "images.csv").write_text(text)
    held = read_block(small).images.held
    assert held is not None
    assert held.tolist() == [True, False]
    (small / "images.csv").write_text(text.replace("b,1,,,,,,,,", "b,1,,,,,,,,1"))
    with pytest.raises(InputError, match=r"image\.held_without_orientation"):
        read_block(small)


def rubbish(path: Path, line: bytes, rows: int) -> None:
    piece = line * 100_000
    with path.open("wb") as file:
        file.write(b"image,point,x_px,y_px,sx_px,sy_px\n")
        for _ in range(rows // 100_000):
            file.write(piece)


@pytest.mark.parametrize(
    "line",
    [b"a,p1,1,2,3,4\n", b"@@@@@@\n", b"c,p1,1,2,3,4\n", b"a,p1,x,y,z,w\n", b"\n", b"\x00\xff\n", b"@", b'"\n'],
    ids=["the same row", "no cells", "unknown image", "no numbers", "empty lines", "bytes", "one line", "quotes"],
)
def test_ten_million_rows_of_rubbish_take_seconds_and_little_memory(small, line):
    import tracemalloc

    rubbish(small / "observations.csv", line, 10_000_000)
    tracemalloc.start()
    began = time.process_time()
    with pytest.raises(InputError):
        read_block(small)
    seconds = time.process_time() - began
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert seconds < 120  # a guard against hanging, not a speed
    assert peak < 400e6
    shutil.rmtree(small)


@pytest.mark.long
def test_a_million_good_rows_read_in_seconds(small):
    with (small / "observations.csv").open("w") as file:
        file.write("image,point,x_px,y_px,sx_px,sy_px\n")
        file.writelines(f"{'ab'[k % 2]},t{k // 2},{k / 7},{k / 3},0.1,0.1\n" for k in range(1_000_000))
    began = time.process_time()
    block = read_block(small)
    assert time.process_time() - began < 120  # a guard against hanging, not a speed
    assert len(block.observations) == 1_000_000
    assert block.observations.xy_px[-1].tolist() == [999_999 / 7, 999_999 / 3]
    assert block.points.ids[-1] == "t499999"


JUNK = [
    b"", b",", b"\n", b'"', b"nan", b"-1", b"1e400", b"\xff", b"\x00", b"a", b"0", b"[", b"{", b"=", b"\r", b"1_0",
    b"\xef\xbb\xbf",
]  # fmt: skip


def damaged(rng, files):
    """The files with up to three pieces replaced by junk."""
    data = {name: bytearray(text.encode()) for name, text in files.items()}
    for _ in range(rng.randint(1, 3)):
        content = data[rng.choice(sorted(data))]
        at = rng.randrange(len(content) + 1)
        content[at : at + rng.choice([0, 1, 5, 20])] = rng.choice(JUNK)
    return data


def outcome(folder):
    """The block, or the error that refuses it."""
    try:
        return read_block(folder)
    except InputError as error:
        return error


def test_damaged_files_are_read_or_refused_and_never_crash(tmp_path):
    rng = random.Random(5)
    files = {**SMALL, "block.toml": TOML + 'interior = "per_image"\n', "interior.csv": INTERIOR}
    folder = tmp_path / "damaged"
    folder.mkdir()
    read = refused = 0
    for k in range(300):
        for name, content in damaged(rng, files).items():
            (folder / name).write_bytes(content)
        found = outcome(folder)
        if isinstance(found, Block):
            read += 1
            write_block(found, tmp_path / str(k))
            assert_same(found, read_block(tmp_path / str(k)))
        else:
            refused += 1
            assert found.file is not None
            assert str(found).startswith(found.file)
    assert read > 3
    assert refused > 50


@pytest.mark.parametrize(
    ("table", "words"),
    [("images.csv", "a block needs it"), ("observations.csv", "a block needs it"), ("points.csv", "delete the file")],
)
def test_a_table_without_rows_is_to_be_deleted_only_where_a_block_can_do_without(small, table, words):
    file = small / table
    file.write_text(SMALL[table].split("\n", 1)[0] + "\n", encoding="utf-8")
    with pytest.raises(InputError, match=r"table\.too_few_rows"):
        read_block(small)
