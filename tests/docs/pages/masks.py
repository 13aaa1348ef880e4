# %%
from pathlib import Path

import numpy as np
from PIL import Image

from raybundle.io.photos.masks import find_masks
from raybundle.io.photos.photo import find_photos

Path("table/photos").mkdir(parents=True)
Path("table/masks").mkdir()
rng = np.random.default_rng(1)
Image.fromarray(rng.integers(0, 255, (240, 320), dtype=np.uint8)).save("table/photos/a.jpg")
mask = np.zeros((240, 320), np.uint8)
mask[60:180, 80:240] = 255  # the object
Image.fromarray(mask).save("table/masks/a.jpg.png")

photos = find_photos([Path("table/photos")]).photos
free = find_masks(Path("table/masks"), photos).of(photos[0])
assert free.mean() == 0.25
