# %%
from pathlib import Path

Path("camera.toml").write_text("""
[cameras.1]
model = "brown"
width_px = 2272
height_px = 1704
pixel_mm = [0.00319, 0.00319]
c_mm = 7.457
x0_mm = -0.0096
y0_mm = 0.1054
K1 = 4.591e-3
K2 = -4.493e-5
K3 = -2.066e-6
P1 = -6.12e-5
P2 = -4.42e-5
""")

# %%
print([entry.name for entry in rb.kept_calibrations(library="library").entries])

from raybundle.io.calibrations import convert_calibration, read_calibrations

(calibration,) = read_calibrations("camera.toml")
for count in ("4", "5", "8"):
    conversion = convert_calibration(calibration, "opencv", variant=count)
    print(f"{count} coefficients: rms {conversion.rms_px:.3f} px, largest {conversion.largest_px:.3f} px")
    print("  " + str(conversion.validity))
assert conversion.largest_px < 0.05
