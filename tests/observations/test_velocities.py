"""Velocities of observed projection centres, by the positions of the same antenna just before and after."""

import numpy as np

from raybundle.observations.station import Stations


def test_velocities_are_differences_of_neighbours_of_one_antenna_and_line():
    rng = np.random.default_rng(3)
    lines = [np.arange(0.0, 8), np.arange(100.0, 104), np.array([200.0]), np.array([300.0, 301.0, 301.0])]
    time = np.concatenate(lines)
    line = np.concatenate([np.full(len(t), k) for k, t in enumerate(lines)])
    n = len(time)
    order = rng.permutation(2 * n)
    time, line, antenna = np.tile(time, 2)[order], np.tile(line, 2)[order], np.repeat([2, 5], n)[order]
    xyz, velocity = rng.normal(size=(2 * n, 3)), np.full((2 * n, 3), np.nan)
    velocity[4] = 1, 2, 3
    antenna[7] = -1
    table = Stations(
        image=np.arange(2 * n), xyz=xyz, sigma=np.ones((2 * n, 3)), antenna=antenna, time=time, velocity=velocity
    )
    for row, found in enumerate(table.velocities):
        beside = np.flatnonzero((antenna == antenna[row]) & (line == line[row]))
        before, after = beside[time[beside] < time[row]], beside[time[beside] > time[row]]
        if row == 4:
            expected = velocity[4]
        elif antenna[row] < 0 or len(before) + len(after) == 0:
            expected = np.full(3, np.nan)
        elif (np.bincount(np.searchsorted(np.unique(time[beside]), time[beside])) > 1).any():
            continue  # two at one time
        else:
            a = before[time[before].argmax()] if len(before) else row
            b = after[time[after].argmin()] if len(after) else row
            expected = (xyz[b] - xyz[a]) / (time[b] - time[a])
        np.testing.assert_allclose(found, expected)
    bare = Stations(image=np.arange(3), xyz=xyz[:3], sigma=np.ones((3, 3)))
    assert np.isnan(bare.velocities).all()
