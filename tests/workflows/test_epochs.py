"""Photographs of several dates in one adjustment: places of each date, what moved, tables."""

import csv
import shutil
from dataclasses import dataclass, replace
from datetime import datetime
from io import BytesIO
from pathlib import Path
from types import SimpleNamespace

import cv2
import numpy as np
import pytest
from PIL import Image

from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block.rejection import RejectionKind
from raybundle.block.select import without_images
from raybundle.commands.epochs import (
    Epochs,
    EpochsSettings,
    _changed,
    _with_warnings,
    epochs,
    groups_of,
    messages_of,
    sources_of,
    trends_of,
    with_movements,
)
from raybundle.errors import InputError, warning
from raybundle.io.block.folder import read_block, write_block
from raybundle.measuring.joint import Joint
from raybundle.metrology.congruence import STRAINED
from raybundle.numerics.progress import silent
from raybundle.report.sections.metrology import displacements
from raybundle.results.displacements import read_displacements
from raybundle.ties.match_weights import Matches, Weights, weighted
from raybundle.workflows.adjust import adjust
from raybundle.workflows.epochs.animation import animation
from raybundle.workflows.epochs.cameras import cameras_by_dates
from raybundle.workflows.epochs.dated_points import adjusted_again, by_dates, placed_by_dates
from raybundle.workflows.epochs.movements import MOVED, movements
from raybundle.workflows.epochs.photograph_dates import (
    Source,
    contradicted,
    date_of,
    dates_of,
    folders_of,
    found_in,
    given_date,
    left_out,
)
from raybundle.workflows.epochs.pictures import DatedPictures
from raybundle.workflows.epochs.stability import _everywhere, _linked, weighted_apart
from raybundle.workflows.epochs.tables import (
    Limit,
    changes_of,
    epochs_json,
    exceeded,
    redated,
    write_displacements,
    write_strains,
    write_velocities,
)
from tests.workflows.dated_network import DAYS, Plan, network


@pytest.fixture(scope="module")
def plan():
    return Plan()


@pytest.fixture(scope="module")
def done(plan):
    rng = np.random.default_rng(4)
    which = np.array([3, 11, 20, 31])
    shares = ((31 / 59, 1), (31 / 59, 1), (0, 1), (0, 1))  # two at a constant velocity, two in the second month
    ways = [np.outer(share, rng.normal(size=3)) for share in shares]
    truth, power = plan.drawn(which, [15.0] * 4, ways)
    assert power.min() > 0.99
    block, dates = network(5, plan.moves(truth))
    return movements(block, dates), truth, which


def test_relief_is_the_same_at_all_dates(done):
    s = done[0].stability
    result, k = s.result, s.tested[0]
    a, b = s.dated.at[k, :2].tolist()
    rough = np.zeros((len(result.adjusted.points), 3))
    rough[a], rough[b] = (1.0, 0.0, 2.0), (0.5, 0.5, 2.5)
    assert result.precision is not None
    rougher = replace(result, precision=replace(result.precision, roughness=rough))

    def difference(joint):
        C = joint.of_points([a, b]).reshape(2, 3, 2, 3)
        return C[0, :, 0] + C[1, :, 1] - C[0, :, 1] - C[1, :, 0]

    smooth = difference(Joint.of(result))
    assert np.allclose(difference(Joint.of(rougher, s.dated.place)), smooth, rtol=1e-6)
    assert np.allclose(Joint.of(rougher, s.dated.place).of_differences(np.array([a]), np.array([b]))[0], smooth)
    apart = Joint.of(rougher)
    linked = np.array([s.dated.at[j, 0] for j in s.tested[:7]]), np.array([s.dated.at[j, 2] for j in s.tested[:7]])
    for p, q, C in zip(*linked, apart.of_differences(*linked), strict=True):
        D = np.hstack([-np.eye(3), np.eye(3)])
        assert np.allclose(C, D @ apart.of_points([int(p), int(q)]) @ D.T, rtol=1e-6, atol=1e-12)
    assert np.trace(difference(Joint.of(rougher))) > np.trace(smooth) + 10
    own = Joint.of(rougher, s.dated.place).of_points([a])
    assert np.trace(own) > 5


def test_what_moved_is_no_noise_to_the_weights(plan):
    rng = np.random.default_rng(8)
    which = rng.choice(len(plan.ids), 12, replace=False)
    truth, _ = plan.drawn(which, [60.0] * 12, list(rng.normal(size=(12, 2, 3))))
    block, dates = network(6, plan.moves(truth))
    o, n = block.observations, len(block.observations)
    matches = Matches(
        images=block.images.ids, image=o.image, xy_px=o.xy_px, grey=np.tile([0.01, 0.01, 0.0], (n, 1)),
        level=np.zeros(n, int), reference=np.zeros(n, bool), feature=np.zeros(n, bool),
    )  # fmt: skip
    spoiled = Weights(factors=(0.0,) * 4, floors_px2=(4.0,) * 4)
    given = weighted(block, [matches], spoiled)
    assert (given.observations.cov_px2[:, 0] == 4).all()
    found, weights, _ = weighted_apart(given, dates, [matches], spoiled)
    assert np.sqrt(found.observations.cov_px2[:, 0]).mean() == pytest.approx(0.3, rel=0.05)
    assert weights.covariance(matches.grey, matches.level, matches.reference)[0, 0] == pytest.approx(0.09, rel=0.1)
    assert movements(found, dates, patches=False).adjustment.sigma0 == pytest.approx(1.0, abs=0.05)


def test_places_of_each_date_and_back():
    block, dates = network(1)
    apart = by_dates(block, dates)
    spanning = int(apart.spanning.sum())
    assert spanning > 40
    assert f"2@{DAYS[0]}" in apart.block.points.ids
    whole = by_dates(apart.block, dates, apart.bases)
    assert set(whole.block.points.ids) <= set(block.points.ids)
    assert len(whole.block.observations) == len(apart.block.observations)
    assert not whole.spanning.any()


def test_what_moved_is_found_with_its_size(plan, done):
    m, truth, which = done
    moved = {p for p, v in zip(m.displacements.point, m.displacements.verdict, strict=True) if v == MOVED}
    assert {plan.ids[k] for k in which} <= moved
    assert len(moved) <= len(which) + 1
    d, place = m.displacements, {i: k for k, i in enumerate(plan.ids)}
    e = np.array([d.vector[k] - truth[d.end[k] - 1, place[p]] for k, p in enumerate(d.point)])
    x = np.einsum("ri,rij,rj->r", e, np.linalg.inv(d.covariance), e) / 3
    assert 0.8 < x.mean() < 1.25
    assert not m.adjustment.datum_defect or "29" not in m.adjustment.datum
    assert f"{plan.ids[which[0]]}@{DAYS[2]}" in m.adjustment.given.points.ids
    assert plan.ids[0] in m.adjustment.given.points.ids


def test_a_constant_velocity_differs_from_a_late_one(plan, done, tmp_path):
    m, truth, which = done
    found = {t.series.name: t for t in m.trends}
    motion = {i: found[plan.ids[i]].verdict(0.05 / len(found)) for i in which}
    assert motion == dict(zip(which, ["constant", "constant", "accelerated", "accelerated"], strict=True))
    for i in which[:2]:
        t = found[plan.ids[i]]
        e = t.velocity - truth[1, i] / 59
        assert e @ np.linalg.solve(t.velocity_covariance, e) < 16.3  # 0.1 % of a chi-square
    write_velocities(trends_of(m, 0.05), tmp_path / "v.csv")
    with (tmp_path / "v.csv").open(encoding="utf-8") as file:
        v = {row["name"]: float(row["vX"]) for row in csv.DictReader(file)}
    assert v[plan.ids[3]] == pytest.approx(365.25 * found[plan.ids[3]].velocity[0], rel=1e-2)


def test_verdicts_agree_with_the_probabilities_they_rest_on(done):
    d = done[0].displacements
    below = d.p_tested < done[0].limit
    assert set(np.array(d.verdict)[below]) == {MOVED, "not_significant"}
    assert set(np.array(d.verdict)[~below]) == {"stable"}


def test_tables_are_read_as_written(done, tmp_path):
    m, _, _ = done
    limit = Limit(length=1e-4, confidence=0.95)
    write_displacements(m, tmp_path / "d.csv", limit)
    read = read_displacements(tmp_path / "d.csv")
    assert len(read.point) == len(m.displacements)
    scatter = np.sqrt(np.diagonal(m.displacements.covariance, axis1=1, axis2=2))
    assert np.allclose(
        read.covariance / scatter[:, :, None] / scatter[:, None],
        m.displacements.covariance / scatter[:, :, None] / scatter[:, None],
        atol=1e-4,
    )
    same = changes_of(m, read, {d: d for d in DAYS})
    assert same.largest < 0.1
    assert not same.verdicts
    contents = epochs_json(m, limit, same)
    assert contents["limit"]["exceeded"]
    assert contents["untested"] == []
    assert min(contents["variance_of_areas_between_halves_of_dates"].values()) >= 1
    assert exceeded(m, limit)
    assert not exceeded(m, replace(limit, length=1.0))


def test_earlier_displacements_are_compared_by_photographs_when_dates_are_given_anew(done, tmp_path):
    m, _, _ = done
    write_displacements(m, tmp_path / "d.csv", None)
    read = read_displacements(tmp_path / "d.csv")
    first, second, third = DAYS
    # delivered while the photographs of the last two dates had each other's date
    swap = {first: first, second: third, third: second}
    before = replace(read, start=tuple(swap[d] for d in read.start), end=tuple(swap[d] for d in read.end))
    photos = {f"{k}.jpg": day for k, day in enumerate(DAYS)}
    now = redated({photo: swap[day] for photo, day in photos.items()}, photos)
    assert now == swap
    found = changes_of(m, before, now)
    assert (found.count, found.missing) == (len(read.point), 0)
    assert found.largest < 0.1
    assert changes_of(m, before, {d: d for d in DAYS}).largest > 5
    assert [n.code for n in _changed(found)] == ["displacement.dates_changed", "displacement.changes"]
    # of the first two dates: the displacement between them has the other sign
    rows = [k for k, pair in enumerate(zip(read.start, read.end, strict=True)) if pair == (first, second)]
    texts = {n: tuple(getattr(read, n)[k] for k in rows) for n in ("point", "start", "end", "verdict")}
    turned = replace(read, vector=-read.vector[rows], covariance=read.covariance[rows], **texts)
    assert changes_of(m, turned, {first: second, second: first, third: third}).largest < 0.1
    # dates that were joined have no counterpart
    assert redated({"a": first, "b": second, "c": third}, {"a": first, "b": first, "c": third}) == {third: third}
    gone = changes_of(m, before, {})
    assert (gone.count, gone.missing) == (0, len(read.point))
    assert [n.code for n in _changed(gone)] == ["displacement.not_compared"]


def test_an_animation_has_a_frame_of_each_date_with_what_moved_until_then(done, tmp_path):
    m, _, _ = done
    block = m.adjustment.adjusted
    names, day = block.images.ids, m.dates.of_image
    images = replace(block.images, file=tuple(f"{i}.jpg" for i in names), date=tuple(DAYS[k] for k in day))
    fewest = [np.flatnonzero(day == k)[0] for k in range(3)]
    block = without_images(replace(block, images=images), ~np.isin(np.arange(len(names)), fewest))
    # the photograph of each date has one grey value, so that what is drawn shows
    camera = block.cameras[0]
    for k in range(3):
        grey = np.full((camera.height_px, camera.width_px), 90 + 50 * k, np.uint8)
        cv2.imwrite(str(tmp_path / images.file[fewest[k]]), grey)
    adjusted = SimpleNamespace(adjusted=block, free_scale=False)
    known = SimpleNamespace(adjustment=adjusted, displacements=m.displacements, dates=m.dates)
    moving = Image.open(BytesIO(animation(known, [tmp_path])))
    assert moving.n_frames == 3
    pictures = DatedPictures.of(block)
    for k in range(3):
        moving.seek(k)
        frame = np.asarray(moving.convert("RGB")).astype(int)
        middle = np.median(frame.reshape(-1, 3), axis=0)
        assert np.abs(middle - (90 + 50 * k)).max() < 6
        orange = (frame[..., 0] > 180) & (frame[..., 2] < 90) | (frame[..., 2] > 150) & (frame[..., 0] < 60)
        assert orange.any() == (k > 0)
    # dots of the last date lie at the points that moved
    d = m.displacements
    rows = [r for r in range(len(d)) if d.end[r] == 2 and d.verdict[r] == MOVED]
    share = frame.shape[1] / pictures.grid.width
    at = pictures.cells(d.xyz[rows]) * share
    inside = ((at > 4) & (at < np.array(frame.shape[1::-1]) - 4)).all(axis=1)
    assert inside.sum() >= 2
    for x, y in at[inside].tolist():
        assert orange[round(y) - 3 : round(y) + 4, round(x) - 3 : round(x) + 4].any()


def test_strains_of_the_surface_stand_in_a_table(done, tmp_path):
    m, _, which = done
    write_strains(m, tmp_path / "s.csv")
    with (tmp_path / "s.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    strains = m.stability.congruence.strains
    assert len(rows) == len(strains) > 20
    assert {r["to"] for r in rows} == set(m.dates.names[1:])
    moved = {m.stability.congruence.ids[k] for k in which}
    still = [float(r["F"]) for r in rows if not moved & set(r["points"].split())]
    assert 0.5 < np.mean(still) < 1.5
    with_moved = [r for r in rows if moved & set(r["points"].split()) and r["to"] == m.dates.names[2]]
    assert all(len(r["points"].split()) == STRAINED for r in rows)
    assert max(float(r["F"]) for r in with_moved) > 5
    assert {r["significant"] for r in rows} == {"yes", ""}


def test_the_camera_of_all_dates_is_one_and_would_be_two(done):
    block, dates = network(1)
    assert [c.id for c in cameras_by_dates(block, dates).cameras] == [f"1@{d}" for d in DAYS]
    (test,) = done[0].stability.cameras
    assert test.shared
    assert test.parameters == ("c", "x0", "y0", "K1")


def test_a_block_keeps_its_dates(tmp_path):
    block, dates = network(1)
    days = tuple(dates.names[k] for k in dates.of_image)
    write_block(replace(block, images=replace(block.images, date=days)), tmp_path / "b")
    assert read_block(tmp_path / "b").images.date == days


def test_dates_of_folders(tmp_path):
    for name in ("2026-05-01", "20260601", "other"):
        (tmp_path / name).mkdir()
    assert [s.date for s in folders_of(Source(path=tmp_path))] == ["2026-05-01", "2026-06-01"]
    assert date_of("2026_13_01") == ""
    with pytest.raises(InputError, match=r"epochs\.no_date_text"):
        given_date("May")


def test_a_date_with_one_photograph_is_named():
    block, dates = network(1)
    keep = (dates.of_image != 1) | (np.arange(len(dates.of_image)) == np.flatnonzero(dates.of_image == 1)[0])
    block = replace(block, observations=block.observations.rows(keep[block.observations.image]))
    with pytest.raises(InputError, match=r"epochs\.dates_not_joined") as error:
        movements(block, dates)
    assert error.value.message is not None
    assert error.value.message.values["date"] == DAYS[1]
    assert error.value.message.values["common"] == 0


def test_without_a_scale_no_length_is_printed(done):
    m = done[0]
    assert m.adjustment.free_scale
    scaled = replace(m, adjustment=replace(m.adjustment, datum_defect=()))
    settings = EpochsSettings(out=Path("dam"))
    found = [
        {
            x.code
            for x in messages_of(
                SimpleNamespace(movements=k, adjustment=k.adjustment, exceeded=(), changes=None, left_out=()), settings
            )[0]
        }
        for k in (scaled, m)
    ]
    assert found[0] - found[1] == {"displacement.largest", "displacement.level_of_detection", "displacement.velocity"}


def test_what_is_warned_of_stands_in_the_report_too(done):
    gone = warning("epochs.photographs_left_out", date=DAYS[0], n=1, total=4, whole=False, copies=0, unusable=1,
                   lost=0, names=["a.jpg"])  # fmt: skip
    first = _Oriented(done[0].adjustment)
    written = _with_warnings(first, done[0], Epochs(orientation=first, movements=done[0], left_out=(gone,)),
                             EpochsSettings(out=Path("dam")))  # fmt: skip
    codes = [n.data.code for n in written.adjustment.notices]
    assert {"epochs.photographs_left_out", "epochs.no_scale"} <= set(codes)
    assert codes[len(codes) - len(first.adjustment.notices) :] == [n.data.code for n in first.adjustment.notices]


def test_without_a_scale_the_report_has_no_millimetres(done):
    o = SimpleNamespace(delivery=SimpleNamespace(findings=(done[0].stability.congruence,)),
                        view=SimpleNamespace(adjustment=SimpleNamespace(free_scale=True)))  # fmt: skip
    (section,) = displacements(o)
    assert " mm" not in str(section)
    assert "'mm'" not in str(section)
    o.view.adjustment.free_scale = False
    assert "'mm'" in str(displacements(o))


def test_dates_that_are_given_again_replace_those_of_before(tmp_path):
    (tmp_path / "project.toml").write_text(
        f"[epochs]\nphotographs = [['{tmp_path}/a', '2026-06-01'], ['b', '2026-07-01']]\n"
    )
    given = EpochsSettings(out=tmp_path, add=(tmp_path / "a",), date=("2026-05-01",))
    assert [(s.path.name, s.date) for s in sources_of(given)] == [("a", "2026-05-01"), ("b", "2026-07-01")]


def test_groups_name_points_or_an_outline(tmp_path):
    block, _ = network(1)
    assert groups_of(["rock:2,NOPE"], block) == {"rock": ("2", "NOPE")}
    with pytest.raises(InputError, match=r"file\.missing"):
        groups_of(["wall:missing.csv"], block)
    file = tmp_path / "wall.csv"
    file.write_text("foo,bar\n-99,-99\n99,-99\n99,99\n")
    with pytest.raises(InputError, match=r"table\.columns_missing"):
        groups_of([f"wall:{file}"], block)
    file.write_text("X;Y\n-999;-999\n999;-999\n999;999\n-999;999\n")
    assert groups_of([f"wall:{file}"], block)["wall"] == block.points.ids
    file.write_text("-999 -999\n999 -999\n999 999\n")
    assert groups_of([f"wall:{file}"], block)["wall"]


def test_linked_photographs_have_the_date_of_their_folder(tmp_path):
    (tmp_path / "archive").mkdir()
    (tmp_path / "may").mkdir()
    (tmp_path / "archive/a.jpg").touch()
    (tmp_path / "may/a.jpg").symlink_to(tmp_path / "archive/a.jpg")
    photo = SimpleNamespace(path=tmp_path / "may/a.jpg", name="a.jpg", metadata=SimpleNamespace(taken=None))
    assert dates_of([photo], [Source(path=tmp_path / "may", date="2026-05-01")]) == {"a.jpg": "2026-05-01"}


@pytest.mark.parametrize(
    ("stated", "taken", "codes"),
    [
        (("05-01", "06-01"), (("05-01", "05-02"), ("06-01", "06-01")), []),
        (("05-01", "06-01"), (("01-01", "01-01"), ("02-01", "02-01")), []),  # a clock that is set wrong
        (("05-01", "06-01"), (("06-01", "06-01"), ("05-01", "05-01")), ["epochs.dates_contradict"]),
        (("05-01", "06-01"), (("05-01", "05-01"), ("05-01", "05-03")), ["epochs.dates_contradict"]),
        (("05-01", "06-01"), (("05-01", "05-20"), ("06-01", "06-01")), ["epochs.date_of_many_days"]),
        (("05-01", "06-01"), ((), ("05-01", "05-01")), []),
    ],
)
def test_dates_that_exif_contradicts(stated, taken, codes):
    days = [(d, t) for d, of in zip(stated, taken, strict=True) for t in of or (None,)]
    photos = [
        SimpleNamespace(name=str(k), metadata=SimpleNamespace(taken=t and datetime.fromisoformat(f"2026-{t}T12:00")))
        for k, (_, t) in enumerate(days)
    ]
    assert [m.code for m in contradicted(photos, {str(k): f"2026-{d}" for k, (d, _) in enumerate(days)})] == codes


@pytest.fixture
def may(tmp_path):
    """A folder with two photographs without metadata."""
    (tmp_path / "may").mkdir()
    for k in range(2):
        cv2.imwrite(str(tmp_path / f"may/{k}.jpg"), np.random.default_rng(k).integers(0, 255, (300, 400), np.uint8))
    return tmp_path / "may"


def test_photographs_are_remembered_once_they_and_their_dates_are_found(may, tmp_path):
    (tmp_path / "empty").mkdir()
    days = ("2026-05-01", "2026-06-01")
    for add, date, code in (
        ((may, tmp_path / "junr"), days, r"file\.missing"),
        ((may, tmp_path / "empty"), days, r"epochs\.source_empty"),
        ((may,), (), r"epochs\.photographs_without_date"),
    ):
        with pytest.raises(InputError, match=code):
            epochs(tmp_path / "dam", add=add, date=date, report=False)
        assert not (tmp_path / "dam/project.toml").exists()


def test_a_copy_keeps_the_first_date_and_is_named(may, tmp_path):
    for name in ("ju", "july"):
        shutil.copytree(may, tmp_path / name)
    (tmp_path / "july/2.jpg").write_bytes((may / "0.jpg").read_bytes()[:2000])
    cv2.imwrite(str(tmp_path / "july/3.jpg"), np.random.default_rng(9).integers(0, 255, (300, 400), np.uint8))
    folders = [Source(path=tmp_path / name, date=f"2026-0{k}-01") for k, name in ((5, "may"), (6, "ju"), (7, "july"))]
    found = found_in(folders)
    dates = dates_of(found.photos, folders)
    assert sorted(dates.values()) == ["2026-05-01"] * 2 + ["2026-07-01"]
    (lone,) = [n for n, d in dates.items() if d == "2026-07-01"]
    june, july = left_out(found, folders, [(lone, "no orientation")])
    assert (june.values["date"], june.values["n"], june.values["total"]) == ("2026-06-01", 2, 2)
    assert {d.code for d in june.details} == {"photograph.copy"}
    assert (july.values["n"], july.values["total"], july.values["whole"]) == (4, 4, True)
    assert [july.values[k] for k in ("copies", "unusable", "lost")] == [2, 1, 1]
    _, dateless = left_out(found, folders[:2], [])
    assert [dateless.values[k] for k in ("date", "n", "total", "whole")] == ["july", 3, 4, False]


@dataclass
class _Oriented:
    """What `with_movements` takes of an orientation."""

    adjustment: object
    weights: object = None
    matches: tuple = ()
    remarks: tuple = ()
    sigma_px: float = 0.0


def test_a_photograph_with_too_few_points_at_its_date_is_left_out_and_named():
    block, dates = network(6)
    block = replace(block, images=replace(block.images, file=tuple(f"{i}.jpg" for i in block.images.ids)))
    o, lone = block.observations, 9
    date = dates.of_image
    mine = np.flatnonzero(o.image == lone)
    # of its points only two are seen by another photograph of its date
    others = np.isin(o.point, o.point[mine[2:]]) & (date[o.image] == date[lone]) & (o.image != lone)
    block = replace(block, observations=o.rows(~others))
    days = {f: DAYS[d] for f, d in zip(block.images.file, date.tolist(), strict=True)}
    done = _Oriented(adjustment=adjust(block, AdjustmentOptions(jobs=1, noise="white")))
    whole, found = with_movements(done, days, EpochsSettings(out=Path("dam")), silent)
    assert found is not None
    out = [n for n in whole.adjustment.notices if n.code == "image_left_out"]
    assert [n.ids for n in out] == [(block.images.ids[lone],)]


def test_data_snooping_goes_on_from_what_was_decided_before():
    block, dates = network(7)
    o, rng = block.observations, np.random.default_rng(2)
    rays = np.bincount(o.point, minlength=len(block.points))
    many = [p for p, n in zip(block.points.ids, rays, strict=True) if n > 15]
    wrong = rng.choice(np.flatnonzero(rays[o.point] > 15), 12, replace=False)
    xy = o.xy_px.copy()
    xy[wrong] += 20.0
    block = replace(block, observations=replace(o, xy_px=xy))
    options = AdjustmentOptions(jobs=1, noise="white", reject="snooping")

    def rejected(result):
        given = result.given
        return {
            (given.images.ids[given.observations.image[k]], dates.base(given.points.ids[given.observations.point[k]]))
            for k, r in enumerate(result.image_observations.rejected)
            if r is not None and r.kind is RejectionKind.BLUNDER
        }

    dated = placed_by_dates(block, dates)
    apart = _linked(dated, _everywhere(dated, dates))
    first = adjusted_again(apart, dates, options, silent, None)
    assert len(rejected(first)) > 8
    same = adjusted_again(apart, dates, options, silent, first, snooping=False)
    assert rejected(same) == rejected(first)
    assert same.weighted_square_sum == pytest.approx(first.weighted_square_sum, rel=1e-6)
    whole = placed_by_dates(block, dates, many).block
    kept = adjusted_again(whole, dates, options, silent, first, snooping=False)
    assert rejected(kept) == rejected(first)
    on, anew = (adjusted_again(whole, dates, options, silent, b) for b in (first, None))
    assert rejected(on) == rejected(anew)
    assert rejected(on) >= rejected(first)


def test_of_one_date_gross_errors_are_looked_for_in_the_end():
    block = network(6)[0]
    block = replace(block, images=replace(block.images, file=tuple(f"{i}.jpg" for i in block.images.ids)))
    xy = block.observations.xy_px.copy()
    xy[100] += 30.0
    block = replace(block, observations=replace(block.observations, xy_px=xy))
    done = _Oriented(adjustment=adjust(block, AdjustmentOptions(jobs=1, noise="white", reject="none")))
    whole, found = with_movements(
        done, dict.fromkeys(block.images.file, DAYS[0]), EpochsSettings(out=Path("dam")), silent
    )
    assert found is None
    assert whole.adjustment.image_observations.rejected[100] is not None
    assert whole.adjustment.given.images.date == (DAYS[0],) * len(block.images)
