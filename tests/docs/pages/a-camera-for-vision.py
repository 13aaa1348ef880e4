# %% The figures above are held by this:
import json

from scipy.optimize import least_squares

from pathlib import Path

truth = json.loads(Path("board/truth.json").read_text())
K0, d0 = np.array(truth["camera_matrix"]), np.array(truth["distortion_coefficients"])
grid = np.stack([a.ravel() for a in np.meshgrid(np.arange(0, 1280, 20.0), np.arange(0, 960, 20.0))], axis=1)
rays = cv2.undistortPointsIter(grid[:, None], K0, d0, None, None, (3, 200, 1e-14))[:, 0]
rays = np.column_stack([rays, np.ones(len(rays))])


def worst(K, distortion, fisheye=False):
    project = cv2.fisheye.projectPoints if fisheye else cv2.projectPoints
    points = rays[:, None] if fisheye else rays

    def off(r):
        return project(points, np.asarray(r), np.zeros(3), K, distortion)[0].reshape(-1, 2) - grid

    best = least_squares(lambda r: off(r).ravel(), np.zeros(3), x_scale=1e-4)
    return np.linalg.norm(off(best.x), axis=1).max()


def near(a, b, share=0.15):
    assert abs(a - b) <= share * abs(b), (a, b)


assert verdict.grade == "good"
near(verdict.uncertainty_px, 0.032)
assert np.abs((cv.K - K0)[[0, 1, 0, 1], [0, 1, 2, 2]] / [cv.std[n] for n in ("fx", "fy", "cx", "cy")]).max() < 4
assert abs(cv.K[0, 0] - 1163.36) < 0.02
far = np.sqrt(np.linalg.eigvalsh(C)[:, -1])
assert far[0] < 0.0025
near(far[2], 0.043)
near(far[3], 0.051)
rho = cv.covariance / np.sqrt(np.outer(np.diag(cv.covariance), np.diag(cv.covariance)))
k1, k2, k3 = (cv.names.index(n) for n in ("k1", "k2", "k3"))
assert abs(rho[k1, k2] + 0.94) < 0.02 and abs(rho[k2, k3] + 0.98) < 0.02
for count, rms_px, grade, uncertainty, error in (
    (5, 0.0059, "good", 0.032, 0.017),
    (8, 0.0059, "usable", 0.032, 0.017),
    (12, 0.0059, "usable", 0.087, 0.12),
    (4, 0.042, "weak", 0.73, 3.2),
):
    near(tried[count][0], rms_px)
    assert tried[count][1] == grade, count
    near(tried[count][2], uncertainty, 0.3)
    its = tried[count][3].opencv(coefficients=count)
    near(worst(its.K, its.distortion, its.fisheye), error, 0.5)
assert tried[12][0] < tried[5][0]
assert {w.split()[0] for w in tried[8][3].adjustment.not_determinable} == {"k4", "k5", "k6"}
distance = np.linalg.norm(station - X.mean(axis=0))
assert abs(distance - truth["distance_mm"]["board_03.jpg"]) < 0.03, distance
z = adjusted.points.xyz
assert abs(np.ptp(z @ np.linalg.svd(z - z.mean(axis=0))[2][2]) - 0.256) < 0.004
near(rms, 0.124)
near(K[0, 0], 1159.66, 1e-4)
assert 12 < (1163.4 - K[0, 0]) / std[0, 0] < 16
near(worst(K, distortion), 5.9, 0.3)
near(freed[0], 0.0083)
assert worst(freed[1], freed[2]) < 0.04
assert "fx" in cv.names and "camera_matrix" in Path("camera.yaml").read_text()
