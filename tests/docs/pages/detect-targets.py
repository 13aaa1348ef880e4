# %% A photograph of a sheet, drawn:
from pathlib import Path

import cv2
import numpy as np

from raybundle.targets.families import families
from raybundle.targets.layout import Disc, Outline, SheetOptions, design
from raybundle.targets.subsets import choose_codes

family = families["aicon12"]
(page,) = design(family, choose_codes(family, 9).ids, SheetOptions(dot_radius_mm=8)).pages
picture = np.full((297 * 12, 210 * 12), 235, np.uint8)
t = np.linspace(0, 2 * np.pi, 200)
for shape in page.shapes:
    if isinstance(shape, Disc):
        outline = np.array([shape.x, shape.y]) + shape.radius * np.stack([np.cos(t), np.sin(t)], axis=1)
    elif isinstance(shape, Outline):
        outline = shape.xy
    else:
        continue
    px = np.round(16 * (outline * [12, -12] + [0, 297 * 12] - 0.5)).astype(np.int32)
    cv2.fillPoly(picture, [px], 20, cv2.LINE_AA, 4)
corners = np.float32([[0, 0], [2519, 0], [2519, 3563], [0, 3563]])
seen = np.float32([[260, 90], [1290, 160], [1180, 1150], [120, 980]])
photo = cv2.warpPerspective(
    cv2.GaussianBlur(picture, (0, 0), 3), cv2.getPerspectiveTransform(corners, seen), (1400, 1200), borderValue=90
)
Path("photos").mkdir()
cv2.imwrite("photos/first.png", photo)
