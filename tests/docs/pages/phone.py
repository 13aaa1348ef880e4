# %% Three photographs of a phone, one of them held upright:
from pathlib import Path

import numpy as np
from PIL import Image

Path("phone").mkdir()
rng = np.random.default_rng(1)
for k, orientation in enumerate([1, 1, 6]):
    exif = Image.Exif()
    exif[0x010F], exif[0x0110], exif[0x0112] = "Maker", "Phone 9", orientation
    details = exif.get_ifd(0x8769)
    details[0x920A], details[0xA405] = 5.6, 26  # focal length and 35 mm equivalent
    pixels = rng.integers(0, 255, (480, 640, 3), dtype=np.uint8)
    Image.fromarray(pixels).save(f"phone/{k + 1}.jpg", exif=exif)

# %%
from raybundle.io.photos.cameras import camera_groups

(camera,) = camera_groups(find_photos([Path("phone")]).photos)
print(f"{camera.id}: c = {camera.c_px:.0f} +- {camera.sigma_c_px:.0f} px, {camera.source}")
assert camera.source == "35 mm equivalent"
