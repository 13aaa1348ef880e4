# %% Four panoramas in a room of 10 x 8 x 4 m, 150 points, six control points
from dataclasses import replace

import numpy as np

from raybundle import adjust
from raybundle.block import Block, Camera, Images, Observations, Points, Role
from raybundle.planning.simulate import measured
from raybundle.numerics.rotation import rotation_from_angles

c, width = 60.0, 40000
pixel = 2 * np.pi * c / width
symbols = ("c", "y0", "K1", "K2", "e", "d", "T", "I", "A")
true = {"c": c, "y0": 0.1, "K1": -4e-6, "e": 0.010, "d": 0.002, "T": 5e-4, "I": 3e-4}
camera = Camera(
    id="pano",
    model="panorama",
    width_px=width,
    height_px=16000,
    pixel_mm=(pixel, pixel),
    values={**dict.fromkeys((*symbols, "u1", "u2"), 0.0), **true},
    estimate=symbols,
)
rng = np.random.default_rng(1)
station = np.array([[2.5, 2.0, 1.5], [7.5, 2.2, 1.6], [7.2, 6.0, 1.4], [2.6, 5.8, 1.7]])
xyz = rng.uniform(0, 1, (400, 3)) * [10, 8, 4]
xyz = xyz[np.linalg.norm(xyz[:, None] - station, axis=2).min(axis=1) > 0.8][:150]
corners = [[0, 0, 0.5], [10, 8, 0.5], [10, 0, 3.4], [0, 8, 3.2], [5, 0, 1.5], [10, 4, 2]]
xyz[:6] = corners
role = np.where(np.arange(150) < 6, Role.CONTROL, Role.TIE)
angles = np.column_stack([np.full(4, np.pi / 2), rng.normal(0, 0.02, 4), rng.uniform(-3, 3, 4)])
truth = Block(
    cameras=(camera,),
    images=Images(
        ids=("p1", "p2", "p3", "p4"),
        camera=np.zeros(4, np.int32),
        file=("",) * 4,
        centre=station,
        rotation=rotation_from_angles(angles),
    ),
    observations=Observations(
        image=np.zeros(0, np.int32), point=np.zeros(0, np.int32), xy_px=np.zeros((0, 2)), cov_px2=np.zeros((0, 3))
    ),
    points=Points(
        ids=tuple(str(k + 1) for k in range(150)),
        role=role,
        xyz=xyz,
        sigma=np.where(role[:, None] == Role.CONTROL, 0.0005, np.full((150, 3), np.nan)),
    ),
)
truth = measured(truth, 0.25)  # image points of 0.25 px
noise = rng.normal(0, 0.25, truth.observations.xy_px.shape)
block = replace(truth, observations=replace(truth.observations, xy_px=truth.observations.xy_px + noise))

found = adjust(block).interior[0].parameters
for symbol in symbols:
    print(f"{symbol:3s} {found[symbol].value: .3e} +- {found[symbol].std:.1e}")
    assert abs(found[symbol].value - camera.values[symbol]) < 5 * found[symbol].std
assert found["e"].std < 1.2e-4  # a tenth of a millimetre
plain = replace(camera, values={**camera.values, "e": 0.0, "d": 0.0, "T": 0.0}, estimate=("c", "y0", "K1", "K2"))
result = adjust(replace(block, cameras=(plain,)))
lower, statistic, upper = result.global_test
print(f"sigma0 {result.sigma0:.1f}; {statistic:.0f} where {upper:.0f} are allowed")
assert statistic > 5 * upper
