# %%
from raybundle.platforms import sensor_models
import numpy as np

r, V = 0.028 / 12.0, 12.0  # 28 ms for 12 mm, 12 m/s to the right
rolling, way = sensor_models["brown_rolling"], sensor_models["brown_trajectory"]
lens = {"c": 11.0, "K1": -2e-4}
read = np.array([(lens | {"r": r, "vx": V}).get(s, 0.0) for s in rolling.symbols])
steady = np.array([(lens | {"vx": -r * V}).get(s, 0.0) for s in way.symbols])
braking = np.array([(lens | {"vx": -r * V, "ax": 2e-4}).get(s, 0.0) for s in way.symbols])
point = np.array([[3.0], [14.0], [-40.0]])
assert np.allclose(way.project(point, steady)[0], rolling.project(point, read)[0])
assert np.hypot(*(way.project(point, braking)[0] - way.project(point, steady)[0])).item() > 5e-4  # mm
