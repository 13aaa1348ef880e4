"""Control of a table as one action, and masks drawn as polygons: checks, undo, pictures, what orient takes."""

import numpy as np
import pytest
from PIL import Image

from raybundle.cli.main import main
from raybundle.errors import InputError
from raybundle.io.block.folder import write_block
from raybundle.io.photos.masks import find_masks
from raybundle.io.photos.photo import read_photo
from raybundle.measuring.actions.control import control_of_text
from raybundle.measuring.actions.masks import drawn_by_file, free_of, write_masks
from raybundle.measuring.actions.verbs import action_of
from raybundle.measuring.journal import Journal
from raybundle.measuring.merge import merge
from raybundle.measuring.names import Known
from raybundle.measuring.state import folded
from tests.measuring.scenes import simulation

TABLE = "point,X,Y,Z,sX,sY,sZ,role\nA,1,2,3,0.01,0.01,0.02,control\nB,4,5,6,,,,check\n"
SQUARE = [[10, 20], [30, 20], [30, 60], [10, 60]]


@pytest.fixture
def journal(tmp_path):
    with Journal.open(tmp_path / "measured.db", Known.of_photos({"a.jpg": (100, 80), "b.jpg": (100, 80)})) as journal:
        yield journal


def test_a_table_is_one_action_and_one_undo(journal):
    action, _ = control_of_text(TABLE, "control.csv")
    assert journal.append(action, id="drop") == journal.append(action, id="drop") == 1
    points = journal.state.points
    assert (points["A"].role, points["B"].role) == ("control", "check")
    assert points["A"].sigma == (0.01, 0.01, 0.02)
    journal.append_verb("undo", {})
    assert not journal.state.points
    assert journal.state.can_redo == 1


def test_single_actions_of_older_journals_mean_the_same(journal):
    action, _ = control_of_text(TABLE, "control.csv")
    single = [
        action_of("point", {"point": p.point, "role": p.role, "xyz": p.xyz, "sigma": p.sigma}) for p in action.points
    ]
    assert folded(single).points == folded([action]).points


@pytest.mark.parametrize(
    ("rows", "words"),
    [
        ("A,1,2,3,0.01,0.01,0.01,control\nA,1,2,3,0.01,0.01,0.01,control\n", "control.csv"),
        ("A,1,2,x,0.01,0.01,0.01,control\n", "control.csv"),
        ("A,,,,,,,control\n", "control.csv"),
        ("A,1e12,2,3,0,0,0,control\n", r"1.*number\.too_large"),
    ],
)
def test_tables_that_are_refused_leave_nothing(journal, rows, words):
    with pytest.raises(InputError, match=words):
        journal.append(control_of_text(TABLE.splitlines()[0] + "\n" + rows, "control.csv")[0])
    assert not journal.state.points


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"polygon": SQUARE[:2]}, r"2.*3.*mark\.mask_corners"),
        ({"polygon": [[0, 0], [50, 0], [90, 0]]}, r"1.*mark\.mask_area"),
        ({"polygon": [[0, 0], [50, 0], [90, 81]]}, r"100.*80.*mark\.outside_image"),
        ({"polygon": [[0, 0], [50, 0], [90, float("nan")]]}, r"number\.not_finite"),
        ({"image": "c.jpg"}, r"2.*mark\.unknown_image"),
        ({"mask": " x"}, r"mark\.bad_name"),
    ],
)
def test_masks_that_are_refused(journal, change, words):
    with pytest.raises(InputError, match=words):
        journal.append_verb("mask", {"mask": "tree", "image": "a.jpg", "polygon": SQUARE} | change)


def test_masks_are_replaced_taken_away_and_undone(journal):
    journal.append_verb("mask", {"mask": "tree", "image": "a.jpg", "polygon": SQUARE})
    journal.append_verb("mask", {"mask": "tree", "image": "b.jpg", "polygon": SQUARE[:3], "camera": True})
    assert journal.state.masks["tree"].image == "b.jpg"
    with pytest.raises(InputError, match=r"mark\.no_mask"):
        journal.append_verb("unmask", {"mask": "car"})
    journal.append_verb("unmask", {"mask": "tree"})
    assert not journal.state.masks
    journal.append_verb("undo", {})
    assert len(journal.state.masks["tree"].polygon) == 3


def test_pixels_in_a_polygon_are_masked():
    free = free_of([np.array(SQUARE, float)], (100, 80))
    assert free.shape == (80, 100)
    assert not free[20:60, 10:30].any()
    # nothing but the pixels that an edge passes is masked beside
    assert 20 * 40 <= (~free).sum() <= 22 * 42
    assert free[40, 8]
    assert free[40, 32]


def test_masks_drawn_and_given_are_written_together(tmp_path):
    """One drawn in one photograph, one for all of its camera, one given; an EXIF orientation changes nothing."""
    block = simulation().observed
    names, files = block.images.ids[:2], block.images.file[:2]
    exif = Image.Exif()
    exif[274] = 3
    size = block.cameras[0].width_px, block.cameras[0].height_px
    for folder in ("photos/ring", "given/ring"):
        (tmp_path / folder).mkdir(parents=True)
    for k, file in enumerate(files):
        Image.new("L", size, 9 + k).save(tmp_path / "photos" / file, exif=exif)
    given = np.full((size[1], size[0]), 255, np.uint8)
    given[:10] = 0
    Image.fromarray(given).save(tmp_path / "given" / f"{files[1]}.png")
    state = folded([
        action_of("mask", {"mask": "one", "image": names[0], "polygon": SQUARE}),
        action_of("mask", {"mask": "all", "image": names[0], "polygon": [[x + 100, y] for x, y in SQUARE],
                           "camera": True}),
    ])  # fmt: skip
    drawn = drawn_by_file(block, state)
    assert len(drawn) == len(block.images)
    photos = [read_photo(tmp_path / "photos" / file, name=file) for file in files]
    assert write_masks(tmp_path / "masks", photos, drawn, tmp_path / "given") == 2
    found = find_masks(tmp_path / "masks", photos)
    assert not found.doubtful
    first, second = (found.of(p) for p in photos)
    assert not first[20:60, 10:30].any()
    assert second[20:60, 12:28].all()
    assert not first[20:60, 110:130].any()
    assert not second[20:60, 110:130].any()
    assert first[:10].all()
    assert not second[:10].any()


def test_a_control_point_absurdly_far_away_is_refused_at_once():
    block = simulation(control=0).observed
    free = block.points.ids[:4]
    at = block.points.xyz[:4].tolist()
    at[0][0] += 1e9
    state = folded([
        action_of("point", {"point": p, "role": "control", "xyz": xyz, "sigma": [0, 0, 0]})
        for p, xyz in zip(free, at, strict=True)
    ])  # fmt: skip
    with pytest.raises(InputError, match=r"mark\.control_far_away"):
        merge(block, state)


def test_control_without_marks_and_longitude_and_latitude_are_named_at_once(tmp_path, capsys):
    block = simulation(control=0).observed
    write_block(block, tmp_path / "block")
    names = block.points.ids[:2]
    image = block.images.ids[0]
    table = tmp_path / "gcps.csv"
    x, y, z = block.points.xyz[0].tolist()
    rows = "".join(f"{n},{x + k},{y},{z}\n" for k, n in enumerate([*names, "elsewhere"]))
    table.write_text(f"point,X,Y,Z\n{rows}")
    assert main(["mark", "control", str(tmp_path / "block"), str(table)]) == 0
    printed = capsys.readouterr().out
    assert "1 of 3 control points" in printed
    table.write_text(f"point,X,Y,Z\nG1,{x},{y},{z}\n")
    assert main(["mark", "control", str(tmp_path / "block"), str(table)]) == 0
    assert "warning" not in capsys.readouterr().out  # nothing is marked yet
    table.write_text(f"point,X,Y,Z\n{rows}")
    assert main(["mark", "put", str(tmp_path / "block"), image, "else-where", "100", "100"]) == 0
    capsys.readouterr()
    assert main(["mark", "control", str(tmp_path / "block"), str(table)]) == 0
    printed = capsys.readouterr().out
    assert "1 of 3 control points" in printed
    assert "elsewhere" in printed
    table.write_text("point,X,Y,Z\nA,8.541200,47.371200,400\nB,8.541900,47.371800,401\n")
    assert main(["mark", "control", str(tmp_path / "block"), str(table)]) != 0
    assert "longitude and latitude" in capsys.readouterr().err
