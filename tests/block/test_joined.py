"""Projects of one object merged over their common points: the same as if all had been measured together."""

from dataclasses import replace

import numpy as np
import pytest

import raybundle as rb
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block.joined import join_blocks, joint_messages
from raybundle.block.select import select_block, with_rows
from raybundle.block.transform import transform_block
from raybundle.cli.main import main
from raybundle.errors import InputError
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.numerics.transform import SimilarityTransform
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from tests.messages import refused

INNER = AdjustmentOptions(datum="inner", jobs=1)
TURN = rotation_from_vector(np.array([[0.3, -0.8, 1.1]]))[0]
ELSEWHERE = SimilarityTransform(scale=2.5, rotation=TURN, translation=np.array([4.0, -3.0, 8.0]))


@pytest.fixture(scope="module")
def whole():
    return simulate(field_scene(TargetField(rows=4, columns=5, stations=20)), Survey(seed=4, scale_bars=0)).observed


def part(block, images):
    some = select_block(block, "image", np.array(images))
    return with_rows(some, np.ones(len(some.observations), bool))


def split(whole):
    """Images of two halves in each of which every point has two rays."""
    o, n = whole.observations, len(whole.images)
    rng = np.random.default_rng(0)
    for _ in range(500):
        order = rng.permutation(n)
        both = np.sort(order[: n // 2]), np.sort(order[n // 2 :])
        if all(np.bincount(o.point[np.isin(o.image, k)], minlength=len(whole.points)).min() > 1 for k in both):
            return both
    raise AssertionError


def halves(whole):
    """Two projects of half the photographs each: the one in metres, the other in a frame and a scale of its own."""
    one, other = (rb.adjust(part(whole, k), INNER).adjusted for k in split(whole))
    return one, replace(transform_block(other, ELSEWHERE, observed="stay"), free_scale=True)


def renamed(block, points):
    return replace(block, points=replace(block.points, ids=tuple(points.get(n, n) for n in block.points.ids)))


def test_two_halves_give_what_the_whole_gives(whole):
    joined = join_blocks(halves(whole), ["one", "other"], same_camera=True)
    (joint,) = joined.joints
    assert len(joint.common) == len(whole.points)
    assert not joint.apart
    assert joint.transform.scale == pytest.approx(1 / 2.5, rel=0.1)  # each in a scale of its own
    merged, all_ = rb.adjust(joined.block, INNER), rb.adjust(whole, INNER)
    assert merged.redundancy == all_.redundancy
    assert merged.sigma0 == pytest.approx(all_.sigma0, rel=1e-6)
    order = [merged.adjusted.points.ids.index(n) for n in all_.adjusted.points.ids]

    def shape(result, rows):
        lengths = np.linalg.norm(np.diff(result.adjusted.points.xyz[rows], axis=0), axis=1)
        return lengths / lengths.mean()  # nothing measured the scale

    np.testing.assert_allclose(shape(merged, order), shape(all_, np.arange(len(order))), rtol=1e-7)


def test_cameras_of_one_name_are_two_unless_they_are_said_to_be_one(whole):
    joined = join_blocks(halves(whole), ["one", "other"])
    ids = [c.id for c in joined.block.cameras]
    assert len(set(ids)) == 2
    assert ids[1] == f"other:{ids[0]}"
    assert [r.code for r in joined.remarks] == ["join.cameras_renamed"]
    assert len(join_blocks(halves(whole), ["one", "other"], same_camera=True).block.cameras) == 1


def test_images_and_tie_points_of_one_name_stay_apart(whole):
    one, other = halves(whole)
    ties = {n: f"t{k + 1}" for k, n in enumerate(whole.points.ids[:8])}
    one, other = renamed(one, ties), renamed(other, {whole.points.ids[8 + k]: f"t{k + 1}" for k in range(8)})
    other = replace(other, images=replace(other.images, ids=one.images.ids))
    joined = join_blocks([one, other], ["one", "other"])
    block = joined.block
    assert len(block.images) == len(whole.images)
    assert len(set(block.images.ids)) == len(whole.images)
    common = set(joined.joints[0].common)
    assert not any(n.startswith("t") for n in common)
    # each of them is a point of its own
    assert len(block.points) == len(whole.points) + 16
    assert sum(n[0] == "t" and n[1:].isdigit() for n in block.points.ids) == 16


def test_points_that_do_not_carry_the_joint_are_kept_as_two(whole):
    name = whole.points.ids[7]
    carriers = {n: 1.0 for n in whole.points.ids if n != name}
    joined = join_blocks(halves(whole), ["one", "other"], carriers=[None, carriers])
    (joint,) = joined.joints
    assert [n for n, _ in joint.apart] == [name]
    assert f"other:{name}" in joined.block.points.ids
    found = {m.code: m.values for m in joint_messages(joint, "m")}
    assert found["join.points_apart"]["points"] == [name]


def test_too_few_common_points_are_refused_with_their_number(whole):
    one, other = halves(whole)
    other = renamed(other, {n: f"x{n}" for n in other.points.ids[2:]})
    with pytest.raises(InputError, match=r"2.*join\.too_few_common"):
        join_blocks([one, other], ["one", "other"])


def test_the_frame_is_that_of_the_block_that_control_fixes(whole):
    one, other = halves(whole)
    role, sigma = np.array(other.points.role), other.points.sigma.copy()
    role[:4], sigma[:4] = 1, 0.001
    fixed = replace(other, points=replace(other.points, role=role, sigma=sigma), free_scale=False)
    joined = join_blocks([one, fixed], ["one", "other"])
    assert joined.first == "other"
    np.testing.assert_array_equal(joined.block.points.xyz[:4], fixed.points.xyz[:4])
    assert any(r.code == "join.frame_of" and r.values["control"] for r in joined.remarks)


def test_millimetres_and_metres(whole):
    one, other = halves(whole)
    small = replace(transform_block(other, SimilarityTransform(scale=1000.0), observed="follow"), length_unit="mm")
    joined = join_blocks([one, small], ["one", "small"], same_camera=True)
    assert joined.block.length_unit == "m"
    assert joined.joints[0].rms < 1e-3


def written(whole, folder, moved=""):
    """Two results of the halves; in the second a target stands elsewhere."""
    for k, (name, images) in enumerate(zip(("one", "other"), split(whole), strict=True)):
        block = part(whole, images)
        if k and moved:
            block = renamed(block, {moved: "new", whole.points.ids[3]: moved})
        rb.write_result(rb.adjust(block, INNER), folder / name, report="none")
    return [str(folder / "one"), str(folder / "other")]


def test_the_command_merges_results(whole, tmp_path, capsys):
    both, result = str(tmp_path / "both"), str(tmp_path / "r")
    sources = written(whole, tmp_path)
    assert main(["merge", *sources, "--same-camera", "--out", both]) == 0
    told = capsys.readouterr().out
    assert f"{len(whole.points)} common points" in told
    assert "warning" not in told
    assert main(["adjust", both, "--datum", "inner", "--no-report", "--out", result]) == 0
    assert main(["merge", *sources, "--out", both]) != 0
    assert "[folder.exists]" in capsys.readouterr().err


def test_a_target_that_is_another_one_is_found_by_the_congruence_test(whole, tmp_path, capsys):
    name = whole.points.ids[7]
    sources = written(whole, tmp_path, moved=name)
    done = rb.merge_projects(sources, tmp_path / "both")
    (joint,) = done.joints
    assert [n for n, _ in joint.apart] == [name]
    assert f"other:{name}" in done.block.points.ids
    rb.adjust(done.block, INNER)


def test_control_that_contradicts_itself_is_refused(whole):
    one, other = halves(whole)
    ids = list(whole.points.ids[:4])

    def fixed(block, shift):
        role, sigma, xyz = np.array(block.points.role), block.points.sigma.copy(), block.points.xyz.copy()
        for n in ids:
            k = block.points.ids.index(n)
            role[k], sigma[k], xyz[k] = 1, 0.001, whole.points.xyz[whole.points.ids.index(n)] + shift
        points = replace(block.points, role=role, sigma=sigma, xyz=np.where(np.isfinite(xyz), xyz, np.nan))
        return replace(block, points=points, free_scale=False)

    truth = {n: np.array([k, k**2, 0.5 * k]) for k, n in enumerate(ids)}
    whole = replace(
        whole, points=replace(whole.points, xyz=np.array([truth.get(n, np.full(3, np.nan)) for n in whole.points.ids]))
    )
    join_blocks([fixed(one, 0.0), fixed(other, 0.0)], ["one", "other"], same_camera=True)
    with refused("join.control_contradicts"):
        join_blocks([fixed(one, 0.0), fixed(other, 100.0)], ["one", "other"], same_camera=True)


def test_names_that_are_exchanged_are_refused(whole, tmp_path):
    sources = written(whole, tmp_path)
    block = rb.read_block(tmp_path / "other/block")
    turned = dict(zip(block.points.ids, reversed(block.points.ids), strict=True))
    rb.write_result(rb.adjust(renamed(block, turned), INNER), tmp_path / "mixed", report="none")
    with refused("join.points_moved", moved=14, n=20, name="mixed"):
        rb.merge_projects([sources[0], tmp_path / "mixed"], tmp_path / "both")
