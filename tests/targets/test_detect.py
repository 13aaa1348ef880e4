"""Targets found and read on rendered photographs and on real ones."""

import csv
from collections import defaultdict

import numpy as np
import pytest
from PIL import Image

from raybundle.errors import InputError
from raybundle.targets import detect as detect_module
from raybundle.targets.centre import triangle_from_ellipse
from raybundle.targets.detect import DetectionOptions, detect_targets
from raybundle.targets.families import families
from raybundle.targets.pattern import pattern_misfit, settled_misfit
from tests.conftest import DATA
from tests.targets.render import shot

ONLY_RINGS = DetectionOptions(uncoded="none")
LEAST_OF_20_BITS = 5


def photographs(name):
    folder = DATA / "photos" / name
    if not folder.is_dir():
        pytest.skip(f"no photographs {name}: set RAYBUNDLE_DATA")
    return folder


def read(path):
    with Image.open(path) as image:
        return np.array(image.convert("L"))


@pytest.mark.parametrize("name", families)
def test_rings_are_read_at_any_turn_tilt_and_polarity(name):
    f = families[name]
    rng = np.random.default_rng(len(f))
    for k in rng.integers(len(f), size=12):
        s = shot(
            rng, rng.uniform(5, 11), np.radians(rng.uniform(0, 60)), bits=f.bits, code=int(f.codes[k]), ring=f.ring,
            blur=rng.uniform(0.4, 1.0), inverse=(dark := bool(rng.integers(2))), slope=rng.uniform(-0.3, 0.3, 2),
        )  # fmt: skip
        d = detect_targets(s.image, f, ONLY_RINGS)
        assert d.id.tolist() == [f.ids[k]]
        assert d.code.tolist() == [f.codes[k]]
        assert d.polarity.tolist() == [-1 if dark else 1]
        assert np.hypot(*(d.xy_px[0] - s.centre)) < 0.1
        assert np.allclose(d.ellipse[0], s.ellipse, rtol=0.1, atol=1.0)


def test_small_targets_seen_askew():
    f = families["aicon14"]
    rng = np.random.default_rng(1)
    lost = 0
    for k in rng.integers(len(f), size=40):
        s = shot(rng, 4.0, np.radians(rng.uniform(40, 60)), bits=14, code=int(f.codes[k]), blur=rng.uniform(0.5, 0.9))
        d = detect_targets(s.image, f, ONLY_RINGS)
        assert set(d.id.tolist()) <= {f.ids[k]}
        lost += not len(d)
    assert lost <= 1


@pytest.mark.long
@pytest.mark.parametrize("name", ["aicon20", "agisoft20"])
def test_large_rings_of_many_sectors(name):
    """Near targets are bent by perspective, and their sectors begin between the steps of the reading."""
    f = families[name]
    rng = np.random.default_rng(5)
    for k in rng.integers(len(f), size=6):
        s = shot(rng, 26.0, np.radians(rng.uniform(0, 60)), bits=20, code=int(f.codes[k]), ring=f.ring, blur=0.8)
        assert detect_targets(s.image, f, ONLY_RINGS).id.tolist() == [f.ids[k]]


@pytest.mark.parametrize("name", families)
@pytest.mark.parametrize(("radius", "shots"), [(4, 8), (5, 8), (8, 6), (14, 3), (28, 1)])
def test_rings_of_all_sizes(name, radius, shots):
    """Rings of 20 sectors need dots of 5 px radius at least, since a sector is to be seen as broad as a pixel."""
    f = families[name]
    if f.bits == 20 and radius < LEAST_OF_20_BITS:
        pytest.skip("too small for 20 sectors")
    rng = np.random.default_rng(radius)
    for k in rng.integers(len(f), size=shots):
        tilt, blur = np.radians(rng.uniform(0, 60)), rng.uniform(0.4, 1.0)
        s = shot(rng, float(radius), tilt, bits=f.bits, code=int(f.codes[k]), ring=f.ring, blur=blur)
        assert detect_targets(s.image, f, ONLY_RINGS).id.tolist() == [f.ids[k]]


@pytest.mark.long
def test_a_ring_moved_to_where_the_grey_values_want_it():
    """A turn of a fifth of a sector and perspective are found; another code is not made to fit."""
    f = families["aicon20"]
    rng = np.random.default_rng(9)
    code = int(f.codes[1000])
    s = shot(rng, 40.0, np.radians(45), bits=20, code=code, ring=f.ring, noise=2.0)
    values = np.zeros(10)
    values[:2], values[2:5] = s.centre, triangle_from_ellipse(s.ellipse[None])[0]
    values[5] = 0.75
    H = np.linalg.inv(s.plane_from_pixel)
    along = H[:, 0] + H[:, 2]
    along = along[:2] / along[2] - s.projected
    u = np.linalg.solve(np.array([[values[2], 0], [values[3], values[4]]]), along)
    begin = float(np.arctan2(-u[1], u[0])) + 0.2 * 2 * np.pi / 20
    assert pattern_misfit(s.image, values, code, begin, f)[1] > 0.15
    assert settled_misfit(s.image, values, code, begin, f)[1] < 0.03
    assert settled_misfit(s.image, values, code ^ 0b110, begin, f)[1] > 0.3


def test_where_the_code_begins():
    """`begin` is the direction in which sector 0 of the code begins, as the picture is looked at."""
    f = families["aicon12"]
    s = shot(np.random.default_rng(4), 9.0, bits=12, code=int(f.codes[20]), noise=0.5)
    d = detect_targets(s.image, f, ONLY_RINGS)
    H = np.linalg.inv(s.plane_from_pixel)
    direction = H @ [1, 0, 1]  # sector 0 of the rendered ring begins along the first axis of its plane
    along = direction[:2] / direction[2] - s.projected
    assert abs((d.begin[0] - np.arctan2(-along[1], along[0]) + np.pi) % (2 * np.pi) - np.pi) < 0.05


def test_hidden_rings_are_refused_or_read_rightly():
    f = families["aicon14"]
    rng = np.random.default_rng(8)
    read_ = 0
    for k in rng.integers(len(f), size=40):
        begin = rng.uniform(0, 2 * np.pi)
        s = shot(
            rng, rng.uniform(5, 10), np.radians(rng.uniform(0, 50)), bits=14, code=int(f.codes[k]),
            hidden=(begin, begin + 0.2 * np.pi, 0.5),
        )  # fmt: skip
        ids = detect_targets(s.image, f, ONLY_RINGS).id.tolist()
        assert set(ids) <= {f.ids[k]}
        read_ += len(ids)
    assert read_ < 40  # so the wedge did lie on sectors


def test_what_lies_on_a_ring_shows_in_its_sectors(monkeypatch):
    """Mean departures of sectors: small on whole rings, large where a grey wedge left a number to be read."""
    f, rng, seen = families["aicon14"], np.random.default_rng(5), []

    def watched(*given, **more):
        seen.append(pattern_misfit(*given, **more)[1])
        return 0.0, 0.0

    monkeypatch.setattr(detect_module, "pattern_misfit", watched)
    worst = {}
    for hidden in (False, True):
        seen.clear()
        for k in rng.integers(len(f), size=50 if hidden else 15):
            begin = rng.uniform(0, 2 * np.pi)
            s = shot(
                rng, rng.uniform(5, 9), np.radians(rng.uniform(0, 50)), bits=14, code=int(f.codes[k]),
                hidden=(begin, begin + 0.2 * np.pi, rng.choice([0.25, 0.75]), 1.8, 3.1) if hidden else None,
            )  # fmt: skip
            detect_targets(s.image, f, ONLY_RINGS)
        worst[hidden] = np.array(seen)
    assert len(worst[False]) == 15
    assert worst[False].max() < 0.08
    assert len(worst[True]) >= 5
    assert np.median(worst[True]) > 0.12


def test_mirrored_targets_are_not_read():
    f = families["aicon14"]
    chiral = [k for k in range(60, 90) if f.id_of(np.array([int(f"{f.codes[k]:014b}"[::-1], 2)]))[0] != f.ids[k]]
    rng = np.random.default_rng(3)
    for k in chiral[:5]:
        s = shot(rng, 8.0, bits=14, code=int(f.codes[k]))
        assert f.ids[k] not in detect_targets(s.image[:, ::-1], f, ONLY_RINGS).id


def test_sixteen_bits_and_dots_without_rings():
    f = families["aicon14"]
    rng = np.random.default_rng(6)
    s = shot(rng, 7.0, bits=14, code=int(f.codes[9]), low=2000, contrast=9000, noise=60, depth=np.uint16)
    assert detect_targets(s.image, f).id.tolist()[0] == 10
    dot = shot(rng, 7.0, size=80)
    d = detect_targets(dot.image, None)
    assert d.id.tolist() == [-1]
    assert not d.coded.any()
    assert np.hypot(*(d.xy_px[0] - dot.centre)) < 0.03
    assert len(detect_targets(dot.image, None, ONLY_RINGS)) == 0
    assert len(detect_targets(dot.image, None, DetectionOptions(polarity="dark"))) == 0


def test_nothing_to_be_found():
    f = families["aicon12"]
    for image in (np.zeros((200, 300), np.uint8), np.full((40, 30), 65535, np.uint16), np.zeros((3, 3), np.uint8)):
        assert len(detect_targets(image, f)) == 0
    with pytest.raises(InputError, match=r"float64.*8.*16.*target\.image_type"):
        detect_targets(np.zeros((20, 20)), f)


@pytest.mark.data
@pytest.mark.parametrize(
    "file", ["castle-p19/images/0010.jpg", "sceaux-castle/images/100_7105.JPG", "fountain-p11/images/0005.jpg"]
)
def test_no_ring_on_photographs_without_targets(file):
    image = read(photographs(file.split("/")[0]) / file.split("/", 1)[1])
    for family in families.values():
        assert len(detect_targets(image, family, ONLY_RINGS)) == 0


@pytest.mark.data
@pytest.mark.long
def test_all_targets_of_a_panel():
    """39 photographs; MicMac reads 2033."""
    reads = 0
    for path in sorted((photographs("cern-targets") / "images").glob("*.tif")):
        ids = detect_targets(read(path), families["aicon14"], ONLY_RINGS).id.tolist()
        assert len(set(ids)) == len(ids)
        assert set(ids) <= set(range(2, 75))
        reads += len(ids)
    assert reads >= 2047


@pytest.mark.data
def test_targets_of_a_panel():
    """Six of the photographs of the panel: everything another program reads is read, and nothing that is not there."""
    folder = photographs("cern-targets")
    with (folder / "measured.csv").open() as file:
        other = defaultdict(dict)
        for row in csv.DictReader(file):
            other[row["image"]][int(row["code"])] = np.array([float(row["x_px"]), float(row["y_px"])]) + 0.5
    files = sorted((folder / "images").glob("043*"))[1:19:3]
    for path in files:
        d = detect_targets(read(path), families["aicon14"], ONLY_RINGS)
        assert len(set(d.id.tolist())) == len(d)
        assert set(other[path.name]) <= set(d.id.tolist()) <= set(range(2, 75))
        e = np.array([xy - other[path.name][i] for i, xy in zip(d.id, d.xy_px, strict=True) if i in other[path.name]])
        assert np.hypot(*np.median(e, axis=0)) < 0.01
        assert (np.quantile(abs(e), 0.9, axis=0) < 0.1).all()
