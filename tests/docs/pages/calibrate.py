# %% Photographs of a chessboard, drawn: c = 1500 px, a principal point 12 and -8 px off the middle.
from pathlib import Path

import cv2
import numpy as np

from raybundle.planning.synthetic_networks import look_at

size, square, K = (1200, 800), 25.0, np.array([[1500.0, 0, 612], [0, 1500, 392], [0, 0, 1]])
columns, rows, fine = 10, 7, 8  # squares, pixels of the drawing to a millimetre
cells = np.indices((rows, columns)).sum(axis=0) % 2 * 200 + 30
board = np.kron(np.pad(cells, 1, constant_values=230), np.ones((200, 200))).astype(np.uint8)
drawing_from_mm = np.array([[fine, 0, 200 - 0.5], [0, fine, 200 - 0.5], [0, 0, 1]])
middle = np.array([columns, rows]) * square / 2
Path("board").mkdir()
rng = np.random.default_rng(4)
for k in range(8):
    azimuth, tilt = k * 0.9, np.radians(35 if k < 7 else 4)
    out = np.array([np.sin(tilt) * np.cos(azimuth), np.sin(tilt) * np.sin(azimuth), np.cos(tilt)])
    X0 = 480 * out
    R = look_at(X0[None], np.zeros((1, 3)), np.array([k % 4 * np.pi / 2]), up=np.array([0.0, 1.0, 0.0]))[0]
    turned = np.diag([1, -1, -1]) @ R  # image axes of OpenCV: y down, z forward
    plane = np.array([[1, 0, -middle[0]], [0, -1, middle[1]], [0, 0, 0]]) - np.outer(X0, [0, 0, 1])
    seen = K @ turned @ plane @ np.linalg.inv(drawing_from_mm)
    half = np.array([[1, 0, -0.5], [0, 1, -0.5], [0, 0, 1]])  # OpenCV counts from the centre of the first pixel
    photo = cv2.warpPerspective(cv2.GaussianBlur(board, (0, 0), 3), half @ seen, size, borderValue=120)
    noisy = cv2.GaussianBlur(photo, (0, 0), 0.7) + rng.normal(0, 1.5, photo.shape)
    cv2.imwrite(f"board/{k}.png", noisy.clip(0, 255).astype(np.uint8))

# %%
import tomllib

(camera,) = tomllib.loads(Path("calibration/calibration.toml").read_text())["cameras"].values()
c_px = camera["c_mm"] / camera["pixel_mm"][0]
print(f"c {c_px:.1f} px, true 1500")
assert abs(c_px - 1500) < 5

# %% the photographs of the facade are of another camera, and this is its calibration:
from pathlib import Path

truth = Path("demo_data/portal/truth/block.toml").read_text()
Path("calibration/calibration.toml").write_text(truth[truth.index("[cameras") :])
