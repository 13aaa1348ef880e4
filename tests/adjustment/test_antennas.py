"""Observed projection centres with a lever arm, and shifts and drifts of flight lines."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import chi2

from raybundle import AdjustmentOptions, adjust
from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.estimation import open_datum
from raybundle.adjustment.readjust import block_again
from raybundle.adjustment.statistics.interior import plausible_std
from raybundle.block import Instrument, Stations
from raybundle.errors import DatumDefect, InputError
from raybundle.io.block.folder import read_block, write_block
from raybundle.measuring.session import adjusted_as_free
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, aerial_scene
from raybundle.platforms import instrument_models
from raybundle.report.write import write_result
from tests.truth.mixed_blocks import MonteCarlo

LEVER = np.array([0.10, -0.05, 0.30])
SHIFT, DRIFT = ("sx", "sy", "sz"), ("dx", "dy", "dz")


def flight(estimate, control=4, sigma=None):
    """Three strips with an antenna each: the same lever arm, shifts and drifts of their own."""
    survey = Survey(image_sigma_px=0.3, control=control, control_sigma=(0.02, 0.02, 0.02), interior="exact")
    truth = simulate(aerial_scene(AerialStrips(images_per_strip=4, points_per_image=25)), survey).truth
    line, time = np.repeat([0, 1, 2], 4), np.tile(np.arange(4) * 3.0, 3)
    shift = np.array([[0.5, -0.3, 0.2], [1.0, -0.6, 0.4], [-0.4, 0.2, 0.1]])
    drift = np.array([[0.0, 0.0, 0.0], [0.01, -0.02, 0.01], [0.02, 0.0, -0.01]])
    antennas = tuple(
        Instrument(
            id=f"line{k + 1}", model="antenna", estimate=estimate, sigma=sigma or {},
            values=dict(zip(instrument_models["antenna"].symbols, (*LEVER, *shift[k], *drift[k], 0.0), strict=True)),
        )
        for k in range(3)
    )  # fmt: skip
    back = np.swapaxes(truth.images.rotation, 1, 2)
    xyz = truth.images.centre + back @ LEVER + shift[line] + time[:, None] * drift[line]
    stations = Stations(
        image=np.arange(12, dtype=np.int32), xyz=xyz, sigma=np.full((12, 3), 0.03), antenna=line.astype(np.int32),
        time=time,
    )  # fmt: skip
    return replace(truth, instruments=antennas).having(stations)


@pytest.mark.parametrize(
    ("estimate", "sigma"),
    [(SHIFT, None), ((*SHIFT, *DRIFT), None), ((*SHIFT, "ax", "ay", "az"), dict.fromkeys(("ax", "ay", "az"), 0.05))],
    ids=["shift", "drift", "lever arm known to 5 cm"],
)
def test_shifts_drifts_and_lever_arms_have_true_sigmas(estimate, sigma):
    runs = 40
    block = flight(estimate, sigma=sigma)
    found = MonteCarlo.of(block).errors(runs, seed=3)
    assert {*(f"parameters of {i.id}" for i in block.instruments), "image of 1"} <= set(found)
    for kind, (d2, degrees) in found.items():
        low, high = chi2(degrees * runs).interval(0.9995)
        assert low < d2.sum() < high, kind


def test_a_neglected_lever_arm_and_shift_are_noticed():
    block = MonteCarlo.of(flight(SHIFT)).noisy(np.random.default_rng(1))
    good = adjust_block(block)
    without = adjust_block(block.having(replace(block.stations, antenna=None)))
    assert good.global_test[0] < good.global_test[1] < good.global_test[2]
    assert without.global_test[1] > 3 * without.global_test[2]
    (group,) = [g for g in good.groups if g.kind == "station"]
    assert np.abs(group.w[np.isfinite(group.w)]).max() < 4.5


def test_unknown_shifts_of_all_lines_leave_the_position_open():
    with pytest.raises(DatumDefect, match=r"(?s)X.*Y.*Z.*datum\.antennas_unknown"):
        adjust_block(flight(SHIFT, control=0))
    known = adjust_block(flight(SHIFT, control=0, sigma=dict.fromkeys(SHIFT, 0.1)))
    assert known.datum == "control"
    assert known.converged


def test_antennas_go_through_folders(tmp_path):
    block = MonteCarlo.of(flight((*SHIFT, *DRIFT))).noisy(np.random.default_rng(2))
    write_block(block, tmp_path / "block")
    again = read_block(tmp_path / "block")
    assert again.cameras == block.cameras
    assert again.instruments == block.instruments
    np.testing.assert_array_equal(again.stations.antenna, block.stations.antenna)
    np.testing.assert_array_equal(again.stations.time, block.stations.time)
    result = adjust(again)
    assert result.sigma0 == pytest.approx(adjust_block(block).sigma0, rel=1e-5)
    write_result(result, tmp_path / "result")
    assert "Antenna line2" in (tmp_path / "result" / "report.html").read_text(encoding="utf-8")
    text = (tmp_path / "block" / "stations.csv").read_text(encoding="utf-8")
    (tmp_path / "block" / "stations.csv").write_text(text.replace("line3", "line9"), encoding="utf-8")
    with pytest.raises(InputError, match=r"cell\.unknown_id"):
        read_block(tmp_path / "block")


def test_a_shift_need_not_be_known_beforehand():
    """Positions good to metres tell a shift to a metre, and that is as it should be; a tape tells lever arms."""
    antenna = flight(SHIFT).instruments[0]
    symbols = instrument_models["antenna"].symbols
    least = {s: plausible_std(antenna, np.zeros(len(symbols)), k, lambda: np.zeros(0)) for k, s in enumerate(symbols)}
    assert [s for s in symbols if least[s] == np.inf] == [*SHIFT, *DRIFT]
    assert least["ax"] == 0.3


def test_a_free_network_without_the_positions_goes_on():
    """Instruments of which nothing is observed any more have no unknowns in its datum."""
    free = adjusted_as_free(block_again(adjust(flight(SHIFT))))
    assert "scale" in free.datum_defect
    assert np.isfinite(free.precision.object_points).any()


@pytest.mark.parametrize("off", [0.5, 3.0])
def test_control_that_contradicts_is_told_where_shifts_need_it(off):
    """Without control nothing determines the shifts: what contradicts stays, and is told, instead of an open datum."""
    block = MonteCarlo.of(flight(SHIFT, control=3)).noisy(np.random.default_rng(1))
    control = np.flatnonzero(block.points.is_control.all(axis=1))
    xyz = block.points.xyz.copy()
    xyz[control[0]] += [off, -off, 2 * off]
    block = replace(block, points=replace(block.points, xyz=xyz))
    result = adjust(block, AdjustmentOptions(reject="snooping", jobs=1))
    assert result.datum == "control"
    told = [n for n in result.notices if n.code in {"control_not_located", "control_rejected", "control_suspect"}]
    assert told
    assert block.points.ids[control[0]] in {i for n in told for i in n.ids}


def test_an_open_datum_is_named_where_instruments_need_it():
    block = flight(SHIFT, control=0)
    free = {c.id: () for c in block.parametrised}
    free |= {i.id: i.estimate for i in block.instruments}
    left = open_datum(block, AdjustmentOptions(), free, (None,) * len(block.observations))
    assert {"position X", "position Y", "position Z"} <= set(left)
