"""The demonstration: from image coordinates and one scale bar to a calibrated camera."""

import numpy as np
import pytest
from tests.cli.reported import reported, values_of

from raybundle.cli.demo_errors import rigid_difference, together
from raybundle.cli.main import main
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.planning.synthetic_networks import brown_camera


def demo(out, *more):
    return main(["demo", "--out", str(out), *more])


def test_demo_prints_truth_beside_estimate(tmp_path, capsys):
    assert demo(tmp_path / "demo", "--verbose") == 0
    out = capsys.readouterr().out
    table = [line.split() for line in out.splitlines() if line.split()[:1] and line.split()[0] in brown_camera().values]
    assert [row[0] for row in table] == ["c", "x0", "y0", "K1", "K2", "K3", "P1", "P2"]
    for _, _, truth, estimate, sigma, ratio in table:
        assert abs(float(ratio)) < 4.5
        assert abs((float(estimate) - float(truth)) / float(sigma) - float(ratio)) < 0.2
    found = values_of(reported(capsys, "demo", "--out", tmp_path / "demo"))["demo.points"]
    assert found["rms_mm"] == pytest.approx(found["stated_mm"], rel=0.3)
    assert (tmp_path / "demo" / "result" / "report.html").is_file()
    assert demo(tmp_path / "demo") == 0
    assert demo(tmp_path / "demo", "--seed", "2") == 2
    assert "[folder.other_block]" in capsys.readouterr().err


def test_rigid_difference_finds_the_motion_and_leaves_the_scale():
    rng = np.random.default_rng(3)
    truth = rng.normal(size=(50, 3))
    turn = rotation_from_vector(np.array([0.3, -1.0, 2.0]))
    moved = truth @ turn + [5, 6, 7]
    error, found = rigid_difference(moved, truth)
    np.testing.assert_allclose(error, 0, atol=1e-13)
    np.testing.assert_allclose(found, turn, atol=1e-13)
    error, _ = rigid_difference(1.01 * moved, truth)
    np.testing.assert_allclose(error, 0.01 * (truth - truth.mean(axis=0)), atol=1e-12)


@pytest.mark.parametrize(
    ("values", "std", "written"),
    [
        ((20.4, 20.400239, 0.00034), 0.00034, ("20.40000", "20.40024", "0.00034")),
        ((2.1e-4, 2.101e-4, 4.2e-7), 4.2e-7, ("2.1000e-04", "2.1010e-04", "0.0042e-04")),
        ((3e-10, 3.06e-10, 1.6e-11), 1.6e-11, ("3.00e-10", "3.06e-10", "0.16e-10")),
        ((1234.0, 1300.0, 45.0), 45.0, ("1234", "1300", "45")),
    ],
)
def test_numbers_are_written_to_the_second_digit_of_sigma(values, std, written):
    assert together(values, std) == written
