"""Lists of exterior orientations: read in the right convention, by the photographs where the file leaves it open."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from tests.io.trajectories.exterior_lists import UTM, dmc, frame, lists, orientations, refused, rows

from raybundle.adjustment.engine import adjust_block
from raybundle.errors import InputError
from raybundle.io.photos.metadata import Metadata
from raybundle.io.photos.photo import Photo
from raybundle.io.trajectories import (
    decided,
    matched,
    read_trajectory,
    rotations_in,
    trajectory_formats,
    with_positions,
    write_trajectory,
)
from raybundle.placing.attitudes import find_attitudes, observe_attitudes
from raybundle.placing.georeference import georeference
from raybundle.placing.marks import Given, Placing
from raybundle.planning.simulate import measured

LISTS, REFUSED = lists(), refused()
PIXEL = 120.0 / 0.012
"""Camera constant [px]"""


def photographs():
    c = dmc().cameras[0]
    facts = {"width_px": c.width_px, "height_px": c.height_px, "sha256": "", "metadata": Metadata()}
    return [Photo(path=Path(f"{n}.tif"), name=f"{n}.tif", **facts) for n in dmc().images.ids]


def by_photographs(found, use="auto"):
    """Notices of attitudes that the photographs of the block are held against."""
    attitudes, _ = find_attitudes(photographs(), found, use=use, sigma_deg=(0.01, 0.02), crs=UTM)
    state = Placing(block=dmc())
    observe_attitudes(state, photographs(), Given(attitudes=attitudes), frame())
    return {n.code: n for n in state.notices}


def image(rotation, centre, at):
    local = np.einsum("nij,nj->ni", rotation, at - centre)
    return -PIXEL * local[:, :2] / local[:, 2:]


@pytest.mark.parametrize("form", LISTS)
def test_lists_are_read(tmp_path, form):
    file, data, truth, reading = LISTS[form]
    path = tmp_path / file
    path.write_bytes(data)
    found = read_trajectory(path)
    names = [n.replace("DMC_", "my DMC_") if "blanks" in form and "names" in form else n for n in truth.names]
    at = matched(found, [f"{n}.tif" for n in names])
    assert (at >= 0).all()
    if found.readings:
        renamed = replace(found, names=tuple(n.removeprefix("my ") for n in found.names))
        notices = by_photographs(renamed)
        assert notices["attitudes_reading"].values["reading"] == reading
        assert len([c for c in notices if c == "attitudes"]) == 1
        assert "attitudes_contradict" not in notices
        if found.rotation is None:
            with pytest.raises(InputError, match=r"trajectory\.undecided"):
                rotations_in(found, frame())
            with pytest.raises(InputError, match=r"trajectory\.undecided"):
                write_trajectory(found, tmp_path / "out.csv", name="opk")
        found = decided(found, reading)
    below = truth.xyz * [1, 1, 0] + [40.0, -30.0, 450.0] if truth.xyz[0, 0] > 180 else truth.xyz - [0, 0, 1400.0]
    gap = image(found.rotation[at], found.xyz[at], below) - image(truth.rotation, truth.xyz, below)
    assert np.abs(gap).max() < 1e-6
    np.testing.assert_allclose(found.xyz[at], truth.xyz, atol=1e-9)


@pytest.mark.parametrize("form", REFUSED)
def test_lists_that_cannot_be_read_are_refused_with_their_column(tmp_path, form):
    file, text, code, column = REFUSED[form]
    path = tmp_path / file
    path.write_text(text)
    with pytest.raises(InputError) as error:
        read_trajectory(path)
    assert error.value.message.code == code
    assert column is None or error.value.column == column


@pytest.mark.parametrize("name", ["image", "Image", "photo"])
def test_lists_begin_with_any_word_for_images(tmp_path, name):
    """Tables of raybundle's own begin with the same word, and have units in their columns."""
    path = tmp_path / "eo.csv"
    path.write_text(f"{name},X,Y,Z,omega,phi,kappa\na.jpg,1,2,3,11,12,380.5\n")
    assert read_trajectory(path).names == ("a.jpg",)
    path.write_text("image,camera,file,X,Y,Z,omega_deg,phi_deg,kappa_deg\na,1,a.jpg,1,2,3,11,12,13\n")
    with pytest.raises(InputError, match=r"table\.unknown_column"):
        read_trajectory(path)


def test_no_row_of_a_list_without_names_is_taken_for_a_title(tmp_path):
    """The first ones lie near the origin of a local grid, or have a cell that is no number."""
    path = tmp_path / "eo.txt"
    lines = [f"f{k}.jpg {100 + 50 * k}.000 10.000 80.000 96.05 16.17 -1.21" for k in range(4)]
    path.write_text("\n".join(lines))
    assert read_trajectory(path).names == ("f0.jpg", "f1.jpg", "f2.jpg", "f3.jpg")
    path.write_text("\n".join([lines[3].replace("f3.jpg 250.000", "f.jpg 500,018.203"), *lines]))
    with pytest.raises(InputError, match=r"line 1"):
        read_trajectory(path)


def test_one_format_recognises_each_list():
    for form, (file, data, *_) in LISTS.items():
        head = data.decode("cp1252" if form == "degree signs" else "utf-8-sig")[:4096].replace("\r\n", "\n")
        suffix = f".{file.rpartition('.')[2].lower()}"
        assert len([n for n, f in trajectory_formats.items() if f.recognises(head, suffix)]) == 1, form


def test_standard_deviations_and_times(tmp_path):
    path = tmp_path / "a.csv"
    path.write_bytes(LISTS["standard deviations"][1])
    t = read_trajectory(path)
    np.testing.assert_allclose(np.degrees(t.rotation_sigma), np.tile([0.002, 0.003, 0.004], (len(t), 1)))
    np.testing.assert_allclose(t.sigma, np.tile([0.02, 0.02, 0.03], (len(t), 1)))
    path.write_bytes(LISTS["Applanix POSEO"][1])
    np.testing.assert_allclose(read_trajectory(path, name="exterior-list").time, 564155.65)


def test_a_convention_that_is_given_is_taken(tmp_path):
    path = tmp_path / "a.txt"
    path.write_bytes(LISTS["no names, degrees"][1])
    assert "attitudes_reading" not in by_photographs(read_trajectory(path), use="opk-deg")
    assert "attitudes_contradict" in by_photographs(read_trajectory(path), use="pok-deg")
    with pytest.raises(InputError, match=r"attitude\.other_convention"):
        by_photographs(read_trajectory(path), use="matrix")


@pytest.mark.parametrize("order", ["opk", "pok"])
def test_a_large_frame_block_is_oriented_by_a_list_of_unknown_convention(tmp_path, order):
    """Positions of 5 cm, attitudes of 0.005 degrees, no names: observed in the right reading; errors as stated."""
    rng = np.random.default_rng(3)
    o = orientations(order, "gon")
    o.xyz = o.xyz + rng.normal(0, 1, o.xyz.shape) * [0.05, 0.05, 0.08]
    o.angles = o.angles + rng.normal(0, 0.005 / 0.9, o.angles.shape)
    path = tmp_path / "eo.txt"
    names = "omega phi" if order == "opk" else "phi omega"
    path.write_text(f"name X Y Z {names} kappa sX sY sZ\n" + rows(o, "  ", extra=(0.05, 0.05, 0.08)))
    truth = dmc()
    block = measured(truth.having(type(truth.stations).empty()), 0.3)
    photos = photographs()
    found = read_trajectory(path)
    attitudes, _ = find_attitudes(photos, found, use="auto", sigma_deg=(0.005, 0.005), crs=UTM)
    o = block.observations
    block = replace(block, observations=replace(o, xy_px=o.xy_px + rng.normal(0, 0.3, o.xy_px.shape)))
    placed, _ = with_positions(photos, found, UTM)
    done = georeference(block, placed, Given(attitudes=attitudes))
    notices = {n.code: n for n in done.notices}
    assert notices["attitudes_reading"].values["reading"] == f"{order}-gon"
    result = adjust_block(done.block)
    assert 0.9 < result.sigma0 < 1.1
    at = done.frame.local_from_wgs84(frame().wgs84_from_local(truth.images.centre))
    assert np.abs(result.adjusted.images.centre - at).max() < 0.3
