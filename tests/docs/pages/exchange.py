# %%
from raybundle.io.block.folder import read_block
from raybundle.cameras.conversions import camera_from_forward, opencv_fit

camera = read_block("field/block").cameras[0]
fit = opencv_fit(camera)
print(f"k1 {fit.camera.k1:.6f}, p1 {fit.camera.p1:.2e}, deviation {fit.deviation_px:.4f} px")
assert fit.deviation_px < 0.1
back = camera_from_forward(fit.camera, "1")
print(back.camera.model, f"{back.deviation_px:.4f} px")

from raybundle.io.pictures.undistort import undistorted

change = undistorted(camera)
print(change.camera.width_px, change.camera.height_px, change.camera.values["c"])
print("the first pixel lay at", change.map_x[0, 0], change.map_y[0, 0])
