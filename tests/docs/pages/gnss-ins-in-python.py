# %%
from pathlib import Path

Path("flight.MRK").write_text(
    "1\t282401.67\t[2404]\t 101,N\t 107,E\t 129,V\t49.000010,Lat\t8.400000,Lon\t189.231,Ellh\t0.012, 0.011, 0.024\t50,Q\n"
    "2\t282404.10\t[2404]\t  99,N\t 103,E\t 131,V\t49.000150,Lat\t8.400010,Lon\t189.410,Ellh\t0.013, 0.012, 0.027\t50,Q\n"
)

# %%
assert abs(stations.xyz[1, 1] - stations.xyz[0, 1] - 15.57) < 0.02
from raybundle.errors import InputError

place = (456000.0, 5427600.0, 110.0)
try:
    print(local_frame("EPSG:25832+7837", place).crs)
except InputError as error:
    print(error)
print(local_frame("EPSG:25832+7837", place, undulation_m=48.0).remarks[0])
print(local_frame("EPSG:25832", place).remarks[0])
# %% A simulated flight: centres, attitudes, GNSS
from raybundle.planning.flights.uav_networks import Flight, flight_scene
from raybundle.numerics.attitude import NADIR_FROM_BODY
from raybundle.numerics.rotation import rotation_from_vector

rng = np.random.default_rng(1)
scene = flight_scene(Flight(alternating=True, points=2))  # stands for an adjusted block
n = len(scene.centre)
mount = rotation_from_vector(np.radians([0.3, -0.2, 1.1])) @ NADIR_FROM_BODY
body = mount.T @ rotation_from_vector(rng.normal(0, np.radians(0.02), (n, 3))) @ scene.rotation
sigma = np.full((n, 3), [0.02, 0.02, 0.03])
gnss = scene.centre + np.swapaxes(scene.rotation, 1, 2) @ [0.12, -0.05, 0.31] + rng.normal(0, 1, (n, 3)) * sigma

# %%
assert np.all(np.abs(arm.values - [0.12, -0.05, 0.31]) < 4 * arm.std)
# %% Observed positions and attitudes
from raybundle import adjust, read_block, write_block
from raybundle.planning.simulate import measured
from raybundle.numerics.rotation import angles_from_rotation
from raybundle.planning.flights.uav_networks import flight_block, uav_camera

from dataclasses import replace

truth = flight_block(Flight(alternating=True, points=12, camera=replace(uav_camera(), estimate=())))
images, n = truth.images, len(truth.images)
arm, late, askew = np.array([0.12, 0.0, 0.0]), 0.03, np.radians([0.3, -0.2, 1.1])
velocity = (
    16.0 * images.rotation[:, 1] * [1, 1, 0]
)  # along the upper side of the image; in place of the velocity from GNSS
xyz = (
    images.centre
    + np.swapaxes(images.rotation, 1, 2) @ arm
    + velocity * late
    + rng.normal(0, 1, (n, 3)) * [0.02, 0.02, 0.03]
)
angles = angles_from_rotation(rotation_from_vector(-askew) @ images.rotation) + rng.normal(0, np.radians(0.02), (n, 3))
every = np.arange(n, dtype=np.int32)
# %%
write_block(block, "flight")
result = adjust(read_block("flight"))
for name, true in (("gnss", {"ax": 0.12, "dt": late}), ("ins", dict(zip(("bx", "by", "bz"), askew)))):
    found = next(i for i in result.interior if i.camera == name).parameters
    for symbol, value in true.items():
        print(symbol, round(found[symbol].value, 5), "+-", round(found[symbol].std, 5), found[symbol].unit)
        assert abs(found[symbol].value - value) < 4 * found[symbol].std
from raybundle.block.relative import relative_control

lines = np.repeat([0, 1, 2, 3], 8)
constants = rng.normal(0, 0.5, (4, 3))[lines]
flown = flight_block(Flight(alternating=True, points=12, camera=replace(uav_camera(), estimate=())))
flown = flown.having(replace(flown.stations, xyz=flown.stations.xyz + constants))
absolute = adjust(flown)
relative = adjust(relative_control(flown, lines, shift_sigma=(5.0, 5.0, 10.0)))
print(
    "sigma0 with positions as they are:", round(absolute.sigma0, 2), "by their differences:", round(relative.sigma0, 2)
)
assert absolute.sigma0 > 1.2
assert abs(relative.sigma0 - 1) < 0.05
