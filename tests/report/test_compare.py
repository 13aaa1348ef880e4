"""Two results side by side."""

from dataclasses import replace

import numpy as np
import pytest

import raybundle as rb
from raybundle import words
from raybundle.block.rejection import Rejection, RejectionKind
from raybundle.errors import InputError
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, brown_camera, field_scene
from raybundle.report.comparison.common_points import common_points, common_rows
from raybundle.report.comparison.differences import APART, basis_words, point_differences, taken_otherwise
from raybundle.report.comparison.differences import compared as differences_of
from raybundle.report.comparison.page import _parameter_rows, write_comparison
from raybundle.report.comparison.shared import Shared, shared_of
from raybundle.report.text.numbers import unbroken
from raybundle.report.write import write_result
from raybundle.results.folder import read_result
from raybundle.words import headline
from tests.report.test_document import parsed

RNG = np.random.default_rng(3)


def test_common_rows():
    c = common_rows(("a", "b", "c", "d"), ("d", "x", "b"))
    assert c.ids == ("b", "d")
    assert list(c.first) == [1, 3]
    assert list(c.second) == [2, 0]
    assert c.only_first == ("a", "c")
    assert c.only_second == ("x",)


def test_a_similarity_takes_frame_and_scale_away():
    first = RNG.normal(size=(20, 3))
    R = rotation_from_vector(np.array([0.3, -0.2, 0.9]))
    moved = 2.5 * first @ R.T + [10, 20, 30]
    moved[4] += [0.01, 0, 0]
    std = np.full((20, 3), 0.001)
    d = point_differences((first, moved), (std, 2.5 * std), [str(k) for k in range(20)], fitted=True)
    assert d.fit is not None
    assert d.fit.scale == pytest.approx(0.4, abs=1e-3)
    assert np.linalg.norm(d.difference, axis=1).argmax() == 4
    assert np.linalg.norm(d.difference[4]) == pytest.approx(0.004, rel=0.15)
    assert d.std == pytest.approx(np.sqrt(2) * 0.001, rel=1e-2)
    raw = point_differences((first, moved), (std, std), [str(k) for k in range(20)], fitted=False)
    assert raw.fit is None
    assert raw.difference == pytest.approx(moved - first)


def test_too_few_points_for_a_similarity():
    two = np.zeros((2, 3))
    with pytest.raises(InputError):
        point_differences((two, two), (two, two), ["a", "b"], fitted=True)


@pytest.fixture
def folder(case, tmp_path):
    def make(name, adjustment=None):
        write_result(adjustment or case(name), tmp_path / name, report="none")
        return read_result(tmp_path / name)

    return make


def compared(first, second, tmp_path):
    write_comparison(first, second, tmp_path / "compare.html")
    return " ".join(parsed((tmp_path / "compare.html").read_text(encoding="utf-8")).text)


def told(code, **values):
    """An entry as the page shows it."""
    return unbroken(words.headline(f"report_compare.{code}", values))


def test_a_controlled_and_a_free_network(folder, tmp_path):
    text = compared(folder("rich"), folder("free"), tmp_path)
    assert told("transformed", fitted=True) in text
    assert told("transformed", fitted=False) in text
    assert told("common_points", n=29) in text
    assert told("in_sigmas", part=False) in text


def test_two_that_are_the_same_to_the_last_bit_are_told_so_without_a_caution(folder, case, tmp_path):
    first, again = folder("rich"), folder("again", case("rich"))
    assert write_comparison(first, again, tmp_path / "c.html") == ()
    assert shared_of(first, again).same
    assert told("same") in compared(first, first, tmp_path)


def test_a_result_with_itself_has_no_difference(folder, tmp_path):
    result = folder("rich")
    text = compared(result, result, tmp_path)
    assert told("interior_ratio", ratio=0.0, part=False) in text
    assert told("points_differ", n=29, rms=0.0, unit="mm", fitted=True) in text or "× 10⁻" in text


def test_rejected_rays_noise_and_parameters_that_differ_are_counted(folder, case, tmp_path):
    a = case("rich")
    out = [None] * len(a.image_observations.rejected)
    for k in (3, 40, 41):
        out[k] = Rejection(kind=RejectionKind.BLUNDER)
    (interior,) = a.interior
    held = replace(interior.parameters["P1"], std=None, status="held")
    other = replace(
        a, noise=replace(a.noise, kind="fields"),
        image_observations=replace(a.image_observations, rejected=tuple(out)),
        interior=(replace(interior, parameters={**interior.parameters, "P1": held}),),
    )  # fmt: skip
    first, second = folder("rich"), folder("other", other)
    found = taken_otherwise(first, second)
    n = len(out)
    assert [(m.code, m.values) for m in found.messages] == [
        ("report_compare.rejected_otherwise", {"n": n, "first": 0, "second": 3}),
        ("report_compare.noise_models", {"same": False, "first": "white", "second": "fields"}),
        ("report_compare.free_in", {"which": "first", "names": [f"P1 ({interior.camera})"]}),
    ]
    assert unbroken(found) in compared(first, second, tmp_path)
    same = taken_otherwise(first, first)
    assert [(m.code, m.values) for m in same.messages] == [
        ("report_compare.rejected_alike", {"n": n}),
        ("report_compare.noise_models", {"same": True, "first": "white", "second": "white"}),
        ("report_compare.free_alike", {}),
    ]


def test_results_that_have_nothing_in_common(folder, case, tmp_path):
    a = case("resection")

    def renamed(block):
        return replace(
            block,
            cameras=tuple(replace(c, id=f"other {c.id}") for c in block.cameras),
            images=replace(block.images, ids=tuple(f"other {i}" for i in block.images.ids)),
            points=replace(block.points, ids=tuple(f"other {i}" for i in block.points.ids)),
        )

    other = replace(
        a,
        given=renamed(a.given),
        adjusted=renamed(a.adjusted),
        interior=tuple(replace(i, camera=f"other {i.camera}") for i in a.interior),
    )
    text = compared(folder("free"), folder("other", other), tmp_path)
    assert told("no_common_camera") in text
    assert told("common_points", n=0) in text
    assert told("no_common_observation") in text
    assert told("common_images", n=0) in text


def test_metres_and_millimetres(folder, case, tmp_path):
    a = case("rich")

    def in_mm(block):
        return replace(
            block,
            length_unit="mm",
            images=replace(block.images, centre=block.images.centre * 1000),
            points=replace(block.points, xyz=block.points.xyz * 1000, sigma=block.points.sigma * 1000),
        ).having(
            replace(block.distances, length=block.distances.length * 1000, sigma=block.distances.sigma * 1000),
            replace(block.stations, xyz=block.stations.xyz * 1000, sigma=block.stations.sigma * 1000),
        )

    precision = replace(a.precision, object_points=a.precision.object_points * 1e6)
    other = replace(a, given=in_mm(a.given), adjusted=in_mm(a.adjusted), precision=precision)
    write_comparison(folder("rich"), folder("mm", other), tmp_path / "c.html")
    text = " ".join(parsed((tmp_path / "c.html").read_text(encoding="utf-8")).text)
    differ = headline("report_compare.points_differ", {"n": 2, "rms": 0.0, "unit": "", "fitted": True})
    assert "× 10⁻" in text.split(differ.removeprefix("2 ").partition(" 0")[0])[1][:40]


def renamed(result, name_of):
    """A result whose points have other names."""
    block = result.block
    points = replace(block.points, ids=tuple(name_of(n) for n in block.points.ids))
    table = replace(
        result.points, text={**result.points.text, "point": tuple(map(name_of, result.points.text["point"]))}
    )
    return replace(result, block=replace(block, points=points), points=table)


def test_running_numbers_are_common_only_where_their_image_points_agree(folder, tmp_path):
    plain = folder("free")
    ids = list(plain.block.points.ids)
    first = renamed(plain, lambda n: f"t{ids.index(n) + 1}")
    # the same points, but for four that have each other's number
    turn = {0: 1, 1: 2, 2: 3, 3: 0}
    second = renamed(plain, lambda n: f"t{turn.get(ids.index(n), ids.index(n)) + 1}")
    tables = first.points.text["point"], second.points.text["point"]
    found = common_points(*tables, (first.block, second.block))
    assert set(found.namesakes) == {"t1", "t2", "t3", "t4"}
    assert len(found.ids) == len(ids) - 4
    text = compared(first, second, tmp_path)
    assert told("namesakes", n=4, names=list(found.namesakes)) in text
    named = common_points(plain.points.text["point"], plain.points.text["point"], (plain.block, plain.block))
    assert not named.namesakes


def test_results_of_which_only_the_running_numbers_agree_are_compared_by_projection_centres(folder, tmp_path):
    plain = folder("free")
    ids = list(plain.block.points.ids)
    first = renamed(plain, lambda n: f"t{ids.index(n) + 1}")
    second = renamed(plain, lambda n: f"t{(ids.index(n) + 1) % len(ids) + 1}")
    text = compared(first, second, tmp_path)
    assert told("common_points", n=0) in text
    assert told("no_same_point") in text
    assert words.why("report_compare.centres", {"by": "centres"}) in text


def test_lengths_of_free_scale_are_units(folder, tmp_path):
    plain = folder("rich")
    free = replace(plain, block=replace(plain.block, free_scale=True))
    text = compared(free, plain, tmp_path)
    assert " units rms" in text
    assert " mm" not in text.split(told("common_points", n=29))[1]


@pytest.mark.parametrize(("count", "little"), [(4, True), (9, True), (10, False), (29, False)])
def test_the_basis_of_a_similarity_is_told_and_little_is_a_caution(count, little):
    found = basis_words(count, centres=False).messages
    assert found[0].values["redundancy"] == 3 * count - 7
    assert [m.code for m in found[1:]] == ["report_compare.small_basis"] * little


def test_points_and_projection_centres_are_both_a_basis(folder, tmp_path):
    text = compared(folder("rich"), folder("free"), tmp_path)
    assert told("basis", n=29, centres=False, coordinates=87, redundancy=80) in text
    assert told("own_transformation", rms=0.0, unit="mm").partition(" 0")[0] in text
    images = len(folder("rich").images.text["image"])
    assert unbroken(basis_words(images, centres=True).messages[0].headline()) in text


def test_the_headline_says_how_few_points_are_behind_it(folder, tmp_path):
    first, second = folder("rich"), folder("free")
    few = set(first.points.text["point"][:5])
    other = renamed(second, lambda n: n if n in few else f"other {n}")
    text = compared(first, other, tmp_path)
    caution, _ = write_comparison(first, other, tmp_path / "again.html")
    assert caution == basis_words(5, centres=False)
    assert unbroken(caution) in text
    assert write_comparison(first, second, tmp_path / "again.html") == shared_of(first, second).sentences
    assert told("small_redundancy", n=8) in text
    assert [m.code for m in caution.messages] == ["report_compare.basis", "report_compare.small_basis"]


def test_few_projection_centres_alone_are_a_caution_too(folder, tmp_path, monkeypatch):
    monkeypatch.setattr("raybundle.report.comparison.page.SMALL_BASIS", 1000)
    first = folder("free")
    ids = list(first.block.points.ids)
    second = renamed(first, lambda n: f"other {ids.index(n)}")
    caution, _ = write_comparison(first, second, tmp_path / "c.html")
    assert caution == basis_words(len(first.images.text["image"]), centres=True)
    assert unbroken(caution) in compared(first, second, tmp_path)


def test_folders_of_one_name_are_told_apart(case, tmp_path):
    for project in ("north", "south"):
        (tmp_path / project).mkdir()
        write_result(case("rich"), tmp_path / project / "result", report="none")
    first, second = (read_result(tmp_path / p / "result") for p in ("north", "south"))
    assert told("subtitle", first="north/result", second="south/result") in compared(first, second, tmp_path)


def test_notices_stand_with_their_severity_the_gravest_first(folder, tmp_path):
    first, second = folder("rich"), folder("free")
    first.result["warnings"] = [
        {"code": "rejected", "severity": "note", "message": "the remark", "ids": []},
        {"code": "control_suspect", "message": "the fault of an older file", "ids": []},
    ]
    second.result["warnings"] = [{"code": "small_angle", "severity": "warning", "message": "the caution", "ids": []}]
    text = compared(first, second, tmp_path)
    places = [text.index(w) for w in ("the fault of an older file", "the caution", "the remark")]
    assert places == sorted(places)
    assert text[: places[0]].split()[-3:] == ["first", "fault", "control_suspect"]


def pair(tmp_path, seed, drop=0.08):
    """Two results of one block, the second without some of its image observations."""
    plan = TargetField(camera=brown_camera(), rows=6, columns=8, stations=4)
    survey = Survey(seed=seed, image_sigma_px=0.2, control=6, control_sigma=(5e-5,) * 3, points="approximate")
    block = simulate(field_scene(plan), survey).observed
    o, rng = block.observations, np.random.default_rng(seed)
    keys = [(block.images.ids[i], block.points.ids[p]) for i, p in zip(o.image, o.point, strict=True)]
    out = tuple(keys[k] for k in np.flatnonzero(rng.random(len(keys)) < drop))
    made = []
    for name, rejected in (("whole", ()), ("part", out)):
        write_result(rb.adjust(replace(block, rejected=rejected)), tmp_path / f"{name}{seed}", report="none")
        made.append(read_result(tmp_path / f"{name}{seed}"))
    return made


def squares(first, second, shared):
    """Mean squares of normalised differences, of points and of interior orientations."""
    common = common_rows(first.points.text["point"], second.points.text["point"])
    d = differences_of(first, second, common, fitted=False, shared=shared)
    ratio = d.difference / d.std
    rows = [r.ratio for r in _parameter_rows(first, second, shared)]
    return float(np.nanmean(ratio**2)), float(np.nanmean(np.square(rows)))


@pytest.mark.parametrize("runs", [5, pytest.param(60, marks=pytest.mark.long)])
def test_differences_of_a_part_and_the_whole_have_the_stated_variance(tmp_path, runs):
    """Over simulated pairs in either order; as if they were independent, a tenth of it."""
    found, apart = [], []
    for seed in range(runs):
        whole, part = pair(tmp_path, seed)
        shared = shared_of(whole, part)
        assert shared.part == "second"
        assert shared_of(part, whole).part == "first"
        found.append(squares(whole, part, shared))
        assert squares(part, whole, shared_of(part, whole)) == pytest.approx(found[-1])
        apart.append(squares(whole, part, APART))
    for k in range(2):
        values = np.array(found)[:, k]
        if runs > 30:
            assert abs(values.mean() - 1) < 3.29 * values.std(ddof=1) / np.sqrt(runs)
        assert 0.3 < values.mean() < 2
        assert np.array(apart)[:, k].mean() < 0.2
    text = compared(whole, part, tmp_path)
    assert words.why("report_compare.part_of_other", {"part": "second"}) in text
    assert "combined" not in text.lower()


def test_a_real_difference_stands_out_of_a_part(tmp_path):
    whole, part = pair(tmp_path, 1)
    shared = shared_of(whole, part)
    rows = _parameter_rows(whole, part, shared)
    (c,) = [r for r in rows if r.symbol == "c"]
    wrong = replace(c, values=(c.values[0], c.values[0] + 2 * c.std[0]))
    assert abs(wrong.ratio) > 3.29 > abs(replace(wrong, shared=APART).ratio)


def test_what_is_shared_and_noise_that_differs_stand_at_the_head(folder, case, tmp_path):
    first, a = folder("rich"), case("rich")
    other = folder("fields", replace(a, noise=replace(a.noise, kind="fields", ratio_points=1.5)))
    shared = shared_of(first, other)
    assert shared.part == ""
    assert shared.too_large
    n = shared.common
    found = write_comparison(first, other, tmp_path / "c.html")
    assert found == shared.sentences
    assert [(m.code, m.values) for t in found for m in t.messages] == [
        ("report_compare.not_independent", {"n": n, "used_first": n, "used_second": n}),
        ("report_compare.noise_models", {"same": False, "first": "white", "second": "fields"}),
        ("report_compare.noise_ratios", {"first": 1.0, "second": 1.5}),
    ]
    text, head = compared(first, other, tmp_path), unbroken(found[0])
    assert text.index(head) < text.index(told("summary"), text.index(head))
    assert not Shared(common=50, used=(1000, 1000), part="").too_large
