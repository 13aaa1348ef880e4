# %%
from raybundle import adjust
from raybundle.block import Camera
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.planning.simulate import Survey, simulate

camera = Camera(
    id="1",
    model="division",
    width_px=6000,
    height_px=4000,
    pixel_mm=(0.004, 0.004),
    values={"c": 20.4, "x0": 0.04, "y0": -0.06, "L": 1.5e-4},
    estimate=("c", "x0", "y0", "L"),
)
simulation = simulate(field_scene(TargetField(camera=camera)), Survey(scale_bars=1))
result = adjust(simulation.observed)
for symbol in model.symbols:
    p = result.interior[0].parameters[symbol]
    print(symbol, p.value, "+-", p.std)
    assert abs(p.value - camera.values[symbol]) < 5 * p.std
# %% Six scans of a relief of 1.2 m, five control points
from dataclasses import replace

rng = np.random.default_rng(2)
scan = Camera(
    id="scan",
    model="sledge",
    width_px=4000,
    height_px=4000,
    pixel_mm=(0.01, 0.01),
    values={"c": 35.0, "x0": 0.0, "s": 0.03, "b": 0.0},
    estimate=("x0", "s", "b"),
    per_image=("s", "b"),
    sigma={"s": 1e-4},
)
from raybundle.block import Block, Images, Observations, Points, Role
from raybundle.planning.synthetic_networks import look_at
from raybundle.planning.simulate import measured

xyz = rng.uniform(-0.6, 0.6, (60, 3)) * [1, 1, 0.4]
role = np.where(np.arange(60) < 5, Role.CONTROL, Role.TIE)
centre = rng.uniform(-0.3, 0.3, (6, 3)) * [3, 3, 0] + [0, 0, 2.2]
none = np.zeros(0, np.int32)
truth = Block(
    cameras=(scan,),
    images=Images(
        ids=tuple("abcdef"),
        camera=np.zeros(6, np.int32),
        file=("",) * 6,
        centre=centre,
        rotation=look_at(centre, 0.2 * centre * [1, 1, 0], np.arange(6) * np.pi / 2, up=np.array([0.0, 1.0, 0.0])),
        interior={k: {"s": 0.03 + 1e-4 * k, "b": 2e-4} for k in range(6)},
    ),
    observations=Observations(image=none, point=none, xy_px=np.zeros((0, 2)), cov_px2=np.zeros((0, 3))),
    points=Points(
        ids=tuple(str(k) for k in range(60)),
        role=role,
        xyz=xyz,
        sigma=np.where(role[:, None] == Role.CONTROL, 2e-5, np.full((60, 3), np.nan)),
    ),
)
truth = measured(truth, 0.2)
noise = rng.normal(0, 0.2, truth.observations.xy_px.shape)
result = adjust(replace(truth, observations=replace(truth.observations, xy_px=truth.observations.xy_px + noise)))
print("sigma0", round(result.sigma0, 2))
assert 0.8 < result.sigma0 < 1.2
for interior in result.interior:
    for symbol, p in interior.parameters.items():
        if interior.image is not None:
            true = truth.images.interior["abcdef".index(interior.image)][symbol]
            assert abs(p.value - true) < 5 * p.std, (interior.image, symbol)
