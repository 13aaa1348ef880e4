# %%
Path("passpunkte.csv").write_text("sep=;\npoint;X;Y;Z;sX\nA;10,125;20,5;5;0,01\nB;12;21,25;4,5;\n", encoding="cp1252")
print(read_control("passpunkte.csv").xyz)
assert read_control("passpunkte.csv").xyz[0, 0] == 10.125

# %%
import numpy as np

from raybundle.io.geo.coordinate_systems import local_frame

frame = local_frame("EPSG:32611", (235_265.0, 3_811_200.0, 10.0))
local = frame.local_from_crs(np.array([[235_269.88, 3_811_198.11, 12.0], [235_262.54, 3_811_203.50, np.nan]]))
print(local)
scale, convergence = frame.scale_and_convergence(np.array([[235_265.0, 3_811_200.0, 10.0]]))[0]
print(f"grid / space {scale:.6f}, convergence {np.degrees(convergence):.3f} deg")
for remark in frame.remarks:
    print("-", remark)
assert np.isnan(local[1, 2])
