"""Ten drawn problems of network design, and what a network of stations is worth in them: by code of its own.

Each problem is an object (triangles) with targets on it, a camera, where one may stand, how targets are seen, and eight
poor stations to begin with.  `worth` is the standard deviation of the targets that the network promises: all stations
free, coordinates in the datum of inner constraints over all targets.  Nothing here is of raybundle: rays by Embree
through trimesh, everything else in NumPy, so that `design_search.py` can say what `raybundle` has to reach.

    python benchmarks/design_problems.py        the problems and what their starts are worth
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import trimesh

MARGIN = 0.02
"""Share of the format along its edges in which nothing is measured."""
UNSEEN = 10.0
"""Worth (logarithm) of a network that leaves targets without two rays; 1 more for each of them."""
STATIONS = 8


@dataclass(frozen=True, slots=True, kw_only=True)
class Problem:
    """One object, one camera, one task; metres."""

    name: str
    vertices: np.ndarray
    triangles: np.ndarray
    targets: np.ndarray
    normals: np.ndarray
    c_px: float
    """Camera constant"""
    size_px: tuple[int, int]
    free: int
    """Parameters of the interior orientation that are free: 0, or c, x0, y0, K1"""
    sigma_px: float
    incidence_deg: float
    """Largest angle between a ray and the normal of the surface"""
    depth: tuple[float, float]
    """Depth of field along the axis"""
    low: np.ndarray
    high: np.ndarray
    """Box in which one may stand"""
    clearance: float
    """Least distance from the boxes of the object"""
    solids: np.ndarray
    """(s, 2, 3) boxes that the object fills"""
    objective: str
    """worst or mean: of the root of a third of the trace of a target's covariance"""
    start: tuple[np.ndarray, np.ndarray, np.ndarray]
    """Centres (8, 3), points looked at (8, 3), rolls (8,) [rad]"""


def boxes_of(*corners: tuple[tuple[float, float, float], tuple[float, float, float]]) -> list[trimesh.Trimesh]:
    return [trimesh.creation.box(bounds=np.array(c, float)) for c in corners]


def placed(mesh: trimesh.Trimesh, count: int, seed: int, wanted=None) -> tuple[np.ndarray, np.ndarray]:
    """Targets far from each other (Gonzalez 1985) and their normals; `wanted(points, normals)` says which may be."""
    points, faces = trimesh.sample.sample_surface(mesh, 6000, seed=seed)
    normals = mesh.face_normals[faces]
    if wanted is not None:
        keep = wanted(points, normals)
        points, normals = points[keep], normals[keep]
    chosen, far = [0], np.linalg.norm(points - points[0], axis=1)
    while len(chosen) < count:
        chosen.append(int(far.argmax()))
        far = np.minimum(far, np.linalg.norm(points - points[chosen[-1]], axis=1))
    return np.ascontiguousarray(points[chosen]), np.ascontiguousarray(normals[chosen])


def ring(middle, distance, height, first_deg=0.0, span_deg=360.0, count=STATIONS):
    a = np.radians(first_deg + span_deg * np.arange(count) / count)
    centre = np.stack([middle[0] + distance * np.cos(a), middle[1] + distance * np.sin(a), np.full(count, height)], 1)
    return centre, np.tile(middle, (count, 1)), np.zeros(count)


def row(first, last, ahead, count=STATIONS):
    """Stations along a line that all look the same way: the normal case of people who walk along a facade."""
    share = (np.arange(count) / (count - 1))[:, None]
    centre = (1 - share) * np.array(first, float) + share * np.array(last, float)
    return centre, centre + np.array(ahead, float), np.zeros(count)


def _box(seed: int, size, objective: str, free: int, count: int) -> Problem:
    rng = np.random.default_rng(seed)
    w, d, h = np.array(size) * rng.uniform(0.9, 1.1, 3)
    (mesh,) = boxes_of(((-w / 2, -d / 2, 0.0), (w / 2, d / 2, h)))
    targets, normals = placed(mesh, count, seed, lambda p, n: (n[:, 2] > -0.5) & (p[:, 2] > 0.05 * h))
    reach = 1.5 * max(w, d)
    return Problem(
        name=f"box-{seed}", vertices=mesh.vertices, triangles=mesh.faces, targets=targets, normals=normals,
        c_px=rng.uniform(3800, 5200), size_px=(6000, 4000), free=free, sigma_px=0.1, incidence_deg=65.0,
        depth=(0.3 * reach, 3.5 * reach), low=np.array([-2.6 * reach, -2.6 * reach, 0.1 * h]),
        high=np.array([2.6 * reach, 2.6 * reach, 2.4 * h]), clearance=0.4 * reach,
        solids=np.array([mesh.bounds]), objective=objective,
        start=ring(np.array([0, 0, h / 2]), 2.3 * reach, 2.2 * h, first_deg=rng.uniform(0, 45)),
    )  # fmt: skip


def _cylinder(seed: int, radius: float, height: float, objective: str, free: int, count: int) -> Problem:
    rng = np.random.default_rng(seed)
    r, h = np.array([radius, height]) * rng.uniform(0.9, 1.1, 2)
    mesh = trimesh.creation.cylinder(radius=r, height=h, sections=64)
    mesh.apply_translation([0, 0, h / 2])
    targets, _ = placed(mesh, count, seed, lambda _, n: np.abs(n[:, 2]) < 0.5)
    out = np.stack([targets[:, 0], targets[:, 1], np.zeros(len(targets))], 1)
    reach = max(2 * r, h)
    return Problem(
        name=f"cylinder-{seed}", vertices=mesh.vertices, triangles=mesh.faces, targets=targets,
        normals=out / np.linalg.norm(out, axis=1, keepdims=True), c_px=rng.uniform(3800, 5200), size_px=(6000, 4000),
        free=free, sigma_px=0.1, incidence_deg=60.0, depth=(0.3 * reach, 4 * reach),
        low=np.array([-3 * reach, -3 * reach, 0.0]), high=np.array([3 * reach, 3 * reach, 1.5 * h]),
        clearance=0.4 * reach, solids=np.array([mesh.bounds]), objective=objective,
        start=ring(np.array([0, 0, h / 2]), 2.7 * reach, 0.5 * h, first_deg=rng.uniform(0, 45)),
    )  # fmt: skip


def _facade(seed: int, objective: str, free: int, count: int) -> Problem:
    """A wall 12 m wide with a niche; one stands in a street before it, the camera on a pole at most."""
    rng = np.random.default_rng(seed)
    w, h = 12 * rng.uniform(0.9, 1.1), 8 * rng.uniform(0.9, 1.1)
    left, right = np.sort(rng.uniform(-0.35, 0.35, 2) * w)
    right = max(right, left + 2.5)
    top, deep = rng.uniform(0.4, 0.7) * h, rng.uniform(0.8, 1.6)
    parts = boxes_of(
        ((-w / 2, 0, 0), (left, deep, h)), ((right, 0, 0), (w / 2, deep, h)), ((left, 0, top), (right, deep, h)),
        ((-w / 2, deep, 0), (w / 2, deep + 0.5, h)),
    )  # fmt: skip
    mesh = trimesh.util.concatenate(parts)

    def wanted(p, n):
        front = (n[:, 1] < -0.5) & ((np.abs(p[:, 1]) < 1e-6) | ((p[:, 0] > left) & (p[:, 0] < right) & (p[:, 2] < top)))
        cheek = (np.abs(n[:, 0]) > 0.5) & (p[:, 1] < 0.97 * deep) & (p[:, 0] > left - 1e-6) & (p[:, 0] < right + 1e-6)
        return (front | (cheek & (p[:, 2] < top))) & (p[:, 2] > 0.2) & (np.abs(p[:, 0]) < 0.49 * w)

    targets, normals = placed(mesh, count, seed, wanted)
    return Problem(
        name=f"facade-{seed}", vertices=mesh.vertices, triangles=mesh.faces, targets=targets, normals=normals,
        c_px=rng.uniform(3300, 4200), size_px=(6000, 4000), free=free, sigma_px=0.15, incidence_deg=70.0,
        depth=(2.0, 40.0), low=np.array([-1.2 * w, -14.0, 1.2]), high=np.array([1.2 * w, -3.0, 4.5]), clearance=2.5,
        solids=np.array([[[-w / 2, 0, 0], [w / 2, deep + 0.5, h]]]), objective=objective,
        start=row((-w / 4, -13.5, 1.6), (w / 4, -13.5, 1.6), (0, 10, 1.2)),
    )  # fmt: skip


def _mesh(seed: int, kind: str, objective: str, free: int, count: int) -> Problem:
    """Meshes with parts that hide others."""
    rng = np.random.default_rng(seed)
    s = rng.uniform(0.9, 1.1, 6)
    if kind == "angle":  # a house with two wings
        corners = [((0, 0, 0), (8 * s[0], 3 * s[1], 4 * s[2])), ((0, 3 * s[1], 0), (3 * s[3], 8 * s[4], 4 * s[2]))]
    elif kind == "portico":  # columns before a wall
        corners = [((-4, 1.5, 0), (4, 2.0, 4 * s[0])), ((-4, 0, 3.4 * s[0]), (4, 1.5, 4 * s[0]))]
        corners += [((x - 0.25, 0.0, 0), (x + 0.25, 0.5, 3.4 * s[0])) for x in (-3.5, -1.2 * s[1], 1.2 * s[2], 3.5)]
    else:  # two machines beside each other
        corners = [((0, 0, 0), (2 * s[0], 1 * s[1], 1.5 * s[2])),
                   ((0.3, 1.9 * s[3] + 0.2, 0), (2 * s[4], 3.1 * s[3] + 0.2, 1.2 * s[5]))]  # fmt: skip
    mesh = trimesh.util.concatenate(boxes_of(*corners))
    solids = np.array(corners, float)

    def wanted(p, n):
        ahead = p + 0.02 * n
        inside = ((ahead[:, None] > solids[:, 0]) & (ahead[:, None] < solids[:, 1])).all(axis=2).any(axis=1)
        shown = (n[:, 2] > -0.5) & (p[:, 2] > 0.1)
        return ~inside & (shown & (n[:, 1] < 0.5) & (p[:, 1] < 1.6) if kind == "portico" else shown)

    targets, normals = placed(mesh, count, seed, wanted)
    low, high = mesh.bounds
    reach = float((high - low)[:2].max())
    middle = (low + high) / 2
    free_low, free_high = low - 1.6 * reach, high + 1.6 * reach
    free_low[2], free_high[2] = 0.3, 2.2 * high[2]
    start = ring(middle, 1.5 * reach, 2.1 * high[2], first_deg=rng.uniform(0, 45))
    if kind == "portico":
        free_high[1] = -1.0
        start = row((-2, -1.5 * reach, 1.6), (2, -1.5 * reach, 1.6), (0, 10, 0.3))
    return Problem(
        name=f"{kind}-{seed}", vertices=mesh.vertices, triangles=mesh.faces, targets=targets, normals=normals,
        c_px=rng.uniform(3300, 4500), size_px=(6000, 4000), free=free, sigma_px=0.1, incidence_deg=70.0,
        depth=(0.2 * reach, 5 * reach), low=free_low, high=free_high, clearance=0.15 * reach, solids=solids,
        objective=objective, start=start,
    )  # fmt: skip


def bumpy(seed: int, objective: str, free: int, count: int) -> Problem:
    """A rock: a ball with bumps and hollows, on the ground."""
    rng = np.random.default_rng(seed)
    mesh = trimesh.creation.icosphere(subdivisions=4)
    v, radius = mesh.vertices.copy(), np.ones(len(mesh.vertices))
    for _ in range(9):
        axis = rng.normal(size=3)
        axis /= np.linalg.norm(axis)
        radius += rng.uniform(-0.3, 0.4) * np.exp(-((1 - v @ axis) / rng.uniform(0.05, 0.2)))
    mesh = trimesh.Trimesh(v * radius[:, None] * [1.2, 1.0, 0.8] + [0, 0, 0.8], mesh.faces, process=False)
    targets, normals = placed(mesh, count, seed, lambda p, n: (p[:, 2] > 0.35) & (n[:, 2] > -0.3))
    low, high = mesh.bounds
    return Problem(
        name=f"rock-{seed}", vertices=mesh.vertices, triangles=mesh.faces, targets=targets, normals=normals,
        c_px=4200.0, size_px=(6000, 4000), free=free, sigma_px=0.1, incidence_deg=70.0, depth=(0.5, 12.0),
        low=np.array([-6, -6, 0.3]), high=np.array([6, 6, 3.0]), clearance=1.0, solids=np.array([[low, high]]),
        objective=objective, start=ring((low + high) / 2, 5.5, 2.8, first_deg=10.0),
    )  # fmt: skip


def problems() -> tuple[Problem, ...]:
    return (
        _box(1, (4, 3, 2.5), "worst", 0, 90),
        _box(2, (0.8, 0.5, 0.4), "mean", 4, 80),
        _cylinder(3, 1.5, 4.0, "worst", 0, 90),
        _cylinder(4, 0.3, 2.0, "mean", 0, 80),
        _facade(5, "worst", 0, 90),
        _facade(6, "mean", 4, 80),
        _mesh(7, "angle", "worst", 0, 90),
        _mesh(8, "portico", "mean", 0, 80),
        _mesh(9, "machines", "worst", 4, 80),
        bumpy(10, "worst", 0, 90),
    )


def look(centre: np.ndarray, at: np.ndarray, roll: np.ndarray) -> np.ndarray:
    """Rotations (n, 3, 3), object axes to image axes (x right, y up, z backwards)."""
    back = centre - at
    back = back / np.linalg.norm(back, axis=1, keepdims=True)
    right = np.cross([0.0, 0.0, 1.0], back)
    plumb = np.linalg.norm(right, axis=1) < 1e-9
    right[plumb] = [1.0, 0.0, 0.0]
    right /= np.linalg.norm(right, axis=1, keepdims=True)
    up = np.cross(back, right)
    c, s = np.cos(roll)[:, None], np.sin(roll)[:, None]
    return np.stack([c * right + s * up, -s * right + c * up, back], axis=1)


class Judge:
    """What networks are worth in one problem."""

    def __init__(self, problem: Problem) -> None:
        self.p = problem
        mesh = trimesh.Trimesh(problem.vertices, problem.triangles, process=False)
        self.rays = trimesh.ray.ray_pyembree.RayMeshIntersector(mesh)
        size = float(np.ptp(problem.vertices, axis=0).max())
        self.off = problem.targets + 1e-4 * size * problem.normals
        p = problem.targets - problem.targets.mean(axis=0)
        zero = np.zeros(len(p))
        turn = np.stack([np.stack([zero, -p[:, 2], p[:, 1]], 1), np.stack([p[:, 2], zero, -p[:, 0]], 1),
                         np.stack([-p[:, 1], p[:, 0], zero], 1)], axis=2)  # fmt: skip
        G = np.concatenate([np.tile(np.eye(3), (len(p), 1, 1)), turn, p[:, :, None]], axis=2)
        self.H = np.linalg.qr(G.reshape(-1, 7))[0].reshape(len(p), 3, 7)

    def violation(self, centre: np.ndarray) -> np.ndarray:
        """(n,) metres by which stations are outside of where one may stand."""
        p = self.p
        out = np.maximum(np.maximum(p.low - centre, centre - p.high), 0).sum(axis=1)
        beside = np.maximum(np.maximum(p.solids[:, 0] - centre[:, None], centre[:, None] - p.solids[:, 1]), 0)
        near = p.clearance - np.linalg.norm(beside, axis=2).min(axis=1)
        return out + np.maximum(near, 0)

    def seen(self, centre: np.ndarray, rotation: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Rows of stations and targets that are measured, and their coordinates in the camera (m, 3)."""
        p = self.p
        sight = p.targets[None] - centre[:, None]
        local = np.einsum("nij,nkj->nki", rotation, sight)
        depth = -local[..., 2]
        with np.errstate(all="ignore"):
            x, y = p.c_px * local[..., 0] / depth, p.c_px * local[..., 1] / depth
        half = (0.5 - MARGIN) * np.array(p.size_px)
        slant = -(sight * p.normals[None]).sum(axis=2) / np.linalg.norm(sight, axis=2)
        ok = (depth > p.depth[0]) & (depth < p.depth[1]) & (np.abs(x) < half[0]) & (np.abs(y) < half[1])
        ok &= slant > np.cos(np.radians(p.incidence_deg))
        image, point = np.nonzero(ok)
        if len(image):
            to = centre[image] - self.off[point]
            hit = self.rays.intersects_any(self.off[point], to / np.linalg.norm(to, axis=1, keepdims=True))
            image, point = image[~hit], point[~hit]
        return image, point, local[image, point]

    def covariances(self, centre: np.ndarray, rotation: np.ndarray) -> np.ndarray | int:
        """(t, 3, 3) of all targets; else the number of targets with less than two rays, or 1 where it falls apart."""
        p, n, t = self.p, len(centre), len(self.p.targets)
        image, point, P = self.seen(centre, rotation)
        rays = np.bincount(point, minlength=t)
        if (rays < 2).any():
            return int((rays < 2).sum() + (rays < 1).sum())
        z = P[:, 2]
        x, y = P[:, 0] / z, P[:, 1] / z
        one, zero = np.ones_like(x), np.zeros_like(x)
        # c x / -z = -c x': derivatives by the point in the camera
        J = -p.c_px * np.stack([np.stack([one, zero, -x], 1), np.stack([zero, one, -y], 1)], 1) / z[:, None, None]
        J /= p.sigma_px
        A = J @ rotation[image]  # by the object point
        cross = np.zeros((len(P), 3, 3))
        cross[:, 0, 1], cross[:, 0, 2], cross[:, 1, 2] = P[:, 2], -P[:, 1], P[:, 0]
        cross -= np.swapaxes(cross, 1, 2)
        B = np.concatenate([-A, J @ cross], axis=2)  # by centre and turn of the camera
        u = 6 * n + p.free
        V = np.zeros((t, 3, 3))
        np.add.at(V, point, np.swapaxes(A, 1, 2) @ A)
        iV = np.linalg.inv(V)
        W = np.zeros((t, 3, u))
        N = np.zeros((u, u))
        BA = np.swapaxes(A, 1, 2) @ B
        for k in range(6):
            np.add.at(W, (point[:, None], np.arange(3)[None], (6 * image + k)[:, None]), BA[:, :, k])
        BB = np.swapaxes(B, 1, 2) @ B
        blocks = np.zeros((n, 6, 6))
        np.add.at(blocks, image, BB)
        for i in range(n):
            N[6 * i : 6 * i + 6, 6 * i : 6 * i + 6] = blocks[i]
        if p.free:
            xi, yi = -x, -y  # tangents of the image
            r2 = xi**2 + yi**2
            D = np.stack([np.stack([xi, yi], 1), np.stack([one, zero], 1), np.stack([zero, one], 1),
                          np.stack([xi * r2, yi * r2], 1)], axis=2) * (p.c_px / p.sigma_px)  # fmt: skip
            N[6 * n :, 6 * n :] = np.einsum("mij,mik->jk", D, D)
            BD = np.swapaxes(B, 1, 2) @ D
            side = np.zeros((n, 6, p.free))
            np.add.at(side, image, BD)
            N[: 6 * n, 6 * n :] = side.reshape(6 * n, p.free)
            N[6 * n :, : 6 * n] = N[: 6 * n, 6 * n :].T
            np.add.at(W[:, :, 6 * n :], point, np.swapaxes(A, 1, 2) @ D)
        M = iV @ W
        S = N - np.einsum("tij,tik->jk", W, M)
        # the seven directions that leave every image as it is, of the stations
        C = np.zeros((u, 7))
        middle, size = p.targets.mean(axis=0), float(np.ptp(p.targets, axis=0).max())
        for i in range(n):
            d = centre[i] - middle
            C[6 * i : 6 * i + 3, :3] = np.eye(3) * size
            C[6 * i : 6 * i + 3, 3:6] = np.array([[0, d[2], -d[1]], [-d[2], 0, d[0]], [d[1], -d[0], 0]])
            C[6 * i + 3 : 6 * i + 6, 3:6] = -rotation[i]
            C[6 * i : 6 * i + 3, 6] = d
        scale = 1 / np.sqrt(np.maximum(np.diag(N), 1e-300))
        C = np.linalg.qr(C / scale[:, None])[0]
        R = scale[:, None] * S * scale[None] + C @ C.T
        low, X = np.linalg.eigh(R)
        if low[0] < 1e-11:
            return 1
        # the inverse on what is determined, times itself: the seven directions out again
        iS = (X / low) @ X.T - C @ C.T
        iS = scale[:, None] * iS * scale[None]
        MS = M @ iS
        QH = iV @ self.H + np.einsum("tiu,uk->tik", MS, np.einsum("tiu,tik->uk", M, self.H))
        HQH = np.einsum("tik,til->kl", self.H, QH)
        Q = iV + MS @ np.swapaxes(M, 1, 2)
        cross = self.H @ np.swapaxes(QH, 1, 2)
        return Q - cross - np.swapaxes(cross, 1, 2) + self.H @ HQH @ np.swapaxes(self.H, 1, 2)

    def sigma(self, centre: np.ndarray, rotation: np.ndarray) -> float:
        """The objective [m]; infinite where targets lack rays."""
        Q = self.covariances(centre, rotation)
        if isinstance(Q, int):
            return np.inf
        each = np.trace(Q, axis1=1, axis2=2) / 3
        return float(np.sqrt(each.max() if self.p.objective == "worst" else each.mean()))

    def worth(self, centre: np.ndarray, rotation: np.ndarray) -> float:
        """Logarithm of the objective relative to the size, or more where targets lack rays or one may not stand."""
        size = float(np.ptp(self.p.targets, axis=0).max())
        wrong = float(self.violation(centre).sum()) / size
        Q = self.covariances(centre, rotation)
        if isinstance(Q, int):
            return UNSEEN + Q + wrong
        each = np.trace(Q, axis1=1, axis2=2) / 3
        value = np.sqrt(each.max() if self.p.objective == "worst" else each.mean())
        return float(np.log(value / size)) + (UNSEEN + wrong if wrong else 0.0)


if __name__ == "__main__":
    import time

    for problem in problems():
        judge = Judge(problem)
        centre, at, roll = problem.start
        rotation = look(centre, at, roll)
        begun = time.process_time()
        for _ in range(20):
            judge.worth(centre, rotation)
        ms = (time.process_time() - begun) / 20 * 1e3
        rays = np.bincount(judge.seen(centre, rotation)[1], minlength=len(problem.targets))
        print(
            f"{problem.name:14} {len(problem.triangles):5} triangles {len(problem.targets)} targets, "
            f"{problem.objective}, {problem.free} free: start {1e3 * judge.sigma(centre, rotation):8.4f} mm, rays "
            f"{rays.min()} to {rays.max()}, outside {judge.violation(centre).max():.2f} m, {ms:.1f} ms"
        )
