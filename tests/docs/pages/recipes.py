# %% Corners of a board of 9 x 7 in eight views
from dataclasses import replace

from raybundle.numerics.rotation import rotation_from_angles

views = np.repeat(np.arange(8), 63)
row, column = np.tile(np.repeat(np.arange(7), 9), 8), np.tile(np.arange(9), 56)
rng = np.random.default_rng(1)
turn = rng.normal(0, 0.35, (8, 3))
lens = replace(block.cameras[0], values=dict.fromkeys(block.cameras[0].values, 0.0) | {"c": 24.0})
X = np.stack([column - 4, 3 - row, np.zeros(504)], axis=1) * 0.03
P = np.einsum("kij,kj->ki", rotation_from_angles(turn)[views], X) - [0, 0, 0.5]
xy = lens.pixel_from_image(-24.0 * P[:, :2] / P[:, 2:]) + rng.normal(0, 0.1, (504, 2))


# %%
assert abs(c - 24.0) < 4 * sigma

from raybundle.planning.simulate import measured

truth = simulate(field_scene(TargetField()), Survey(scale_bars=2)).truth

# %% Image points of 0.2 px
rig = measured(replace(truth, cameras=(left, right), images=images), 0.2)
o = rig.observations
rig = replace(rig, observations=replace(o, xy_px=o.xy_px + rng.normal(0, 0.2, o.xy_px.shape)))

# %%
off = (found.values[at] - [*mounting.values()]) / np.sqrt(np.diag(found.covariance)[at])
assert np.abs(off).max() < 4
