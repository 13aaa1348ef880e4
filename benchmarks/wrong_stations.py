"""Probability of a wrong station: subsets of sets with truth, fitted on some scenes and judged on others.

    python benchmarks/wrong_stations.py draw WORK [--data FOLDER] [--scenes PATTERN] [--subsets N] [--cpu SECONDS]
    python benchmarks/wrong_stations.py fit WORK

draw    orients subsets of 3 to 12 photographs of each scene, `--quick`, and keeps in WORK what was found: contiguous,
        sparse, in two groups, random; in some with one to three photographs that do not belong there (of another
        scene, mirrored), or are changed (cropped, enlarged, stretched).  A second run goes on where the first ended.
fit     the logistic regression of `raybundle.ties.wrong_stations`: of each group of scenes by the others, its
        reliability; of all, the coefficients
--data  a folder with entry-P10 (Strecha et al. 2008), templeSparseRing, dinoSparseRing (Seitz et al. 2006) and
        brighton; photographs and cameras as they were published.  The other scenes are rendered here, or stand in
        RAYBUNDLE_DATA.

A station is right if, after the similarity that most photographs of its part agree with, it is within 1 % of the
extent and 1 degree of its truth.  Extent: the greatest distance of two stations of the part, or the median distance
of a station from its object points if that is larger.  A photograph that is mirrored, or of another scene than most of
its part, is wrong.  The truth of herzjesu-p8, castle-p19, sceaux-castle, copr-uav and brighton is the orientation of
the whole set; that of the others is published or rendered.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import resource
import shutil
from collections.abc import Callable
from dataclasses import dataclass
from itertools import combinations, pairwise
from pathlib import Path
from types import SimpleNamespace

import cv2
import doubles
import numpy as np
import repeated_structure as repeated
from ledger.judges.cameras import middlebury, table
from runs import similarity
from scipy.optimize import minimize
from scipy.sparse import csr_array
from scipy.special import betaincinv, expit

from raybundle.adjustment.result import Adjustment
from raybundle.block import Block
from raybundle.errors import NoOrientation, NotSolvable, Severity
from raybundle.io.block.folder import read_block
from raybundle.io.block.toml import read_cameras
from raybundle.placing.marks import Given
from raybundle.ties import wrong_stations as ws
from raybundle.ties.explained_matches import PairFits
from raybundle.workflows.orient import Orientation, OrientOptions, orient
from raybundle.workflows.orienting.stages import adjustment as stage

HERE = Path(__file__).resolve().parent
RESULTS = HERE / "results/wrong_stations.json"
DATA = Path(os.environ.get("RAYBUNDLE_DATA", HERE.parents[1] / "shared/data")) / "photos"
PORTAL = HERE.parent / "demo_data/portal"
FEATURES, FURTHER = 1500, 0.05
"""Features of a photograph, and share of the subsets that are matched further, to be quick."""
SHARE, DEGREES = 0.01, 1.0
"""Limits of a right station: of the extent, and of the rotation"""
OWN = "reference"
"""Word of sets whose truth is the orientation of all their photographs."""
Truth = dict[str, tuple[np.ndarray, np.ndarray]]
"""Centre and rotation (object to image, x right, y up) of each photograph"""


@dataclass(frozen=True)
class Scene:
    """Photographs with their truth."""

    group: str
    """of scenes with the same object, which are fitted together or judged together"""
    make: Callable[[Path], Truth | None]
    """writes photographs into a folder, and `camera.toml` beside it; None: the truth is the orientation of all"""
    subsets: float = 1.0
    """share of the subsets of others"""


def camera_file(folder: Path, size: tuple[int, int], c: tuple[float, float], at: tuple[float, float]) -> None:
    """A camera without distortion; c and principal point in pixels."""
    w, h = size
    (folder / "camera.toml").write_text(
        f'[cameras.1]\nmodel = "brown"\nwidth_px = {w}\nheight_px = {h}\npixel_mm = [0.001, {0.001 * c[0] / c[1]}]\n'
        f"c_mm = {c[0] * 0.001}\nx0_mm = {(at[0] - w / 2) * 0.001}\n"
        f"y0_mm = {(h / 2 - at[1]) * 0.001 * c[0] / c[1]}\nestimate = []\n",
        encoding="utf-8",
    )


def reduced(source: Path, folder: Path, name: str, factor: float, most: int | None = None) -> None:
    """Copies of photographs, reduced; of the first so many."""
    for path in sorted(p for p in source.iterdir() if p.suffix.lower() in {".jpg", ".png"})[:most]:
        grey = cv2.imread(str(path), cv2.IMREAD_GRAYSCALE)
        small = cv2.resize(grey, None, fx=factor, fy=factor, interpolation=cv2.INTER_AREA) if factor < 1 else grey
        cv2.imwrite(str(folder / f"photos/{name}-{path.stem}.jpg"), small, [cv2.IMWRITE_JPEG_QUALITY, 95])


def strecha(source: Path, name: str, truth: Truth | None) -> Callable[[Path], Truth | None]:
    """A set of Strecha et al. 2008, at a third of its size."""

    def make(folder: Path) -> Truth | None:
        reduced(source, folder, name, 1024 / 3072)
        camera_file(folder, (1024, 683), (2759.48 / 3, 2764.16 / 3), (1520.69 / 3, 1006.81 / 3))
        return None if truth is None else {f"{name}-{Path(k).stem}.jpg": v for k, v in truth.items()}

    return make


def published(folder: Path) -> Truth:
    """NAME.camera of Strecha et al. 2008."""
    found = {}
    for path in sorted(folder.glob("*.camera")):
        rows = [[float(x) for x in line.split()] for line in path.read_text().splitlines() if line.strip()]
        found[path.stem] = (np.array(rows[7]), np.diag([1.0, -1, -1]) @ np.array(rows[4:7]).T)
    return found


def gantry(source: Path, name: str) -> Callable[[Path], Truth]:
    """A set of Seitz et al. 2006."""

    def make(folder: Path) -> Truth:
        reduced(source, folder, name, 1.0)
        camera_file(folder, (640, 480), (1520.4, 1525.9), (302.82, 247.37))
        return {f"{name}-{Path(k).stem}.jpg": v for k, v in middlebury(source).items()}

    return make


def portal(folder: Path) -> Truth:
    """The demonstration."""
    for path in sorted((PORTAL / "photos").iterdir()):
        shutil.copy(path, folder / "photos")
    shutil.copy(PORTAL / "truth/block.toml", folder / "camera.toml")
    text = (folder / "camera.toml").read_text(encoding="utf-8")
    (folder / "camera.toml").write_text(text[text.index("[cameras") :], encoding="utf-8")
    images = read_block(PORTAL / "truth").images
    return {n: (c, R) for n, c, R in zip(images.file, images.centre, images.rotation, strict=True)}


def whole(source: Path, name: str, factor: float) -> Callable[[Path], None]:
    """A set whose truth is the orientation of all its photographs (18 at most)."""

    def make(folder: Path) -> None:
        reduced(source, folder, name, factor, 18)

    return make


def double(kind: str, path: str, *, rich: bool, equal: bool) -> Callable[[Path], Truth]:
    """Rendered equal parts, or the same with different ones."""

    def make(folder: Path) -> Truth:
        name = f"{kind}{'R' if rich else 'P'}{'E' if equal else 'D'}{path}"
        doubles.SUPER = 1
        taken = doubles.photographs(kind, path, rich=rich, equal=equal)
        return rendered(folder, {f"{name}-{k:02d}.jpg": (p.grey, p.centre, p.rotation) for k, p in enumerate(taken)})

    return make


def rendered(folder: Path, taken: dict[str, tuple[np.ndarray, np.ndarray, np.ndarray]], c: float = doubles.C) -> Truth:
    """Files of rendered photographs."""
    for name, (grey, _, _) in taken.items():
        cv2.imwrite(str(folder / "photos" / name), grey, [cv2.IMWRITE_JPEG_QUALITY, 92])
    h, w = next(iter(taken.values()))[0].shape
    camera_file(folder, (w, h), (c, c), (w / 2, h / 2))
    return {n: (centre, R) for n, (_, centre, R) in taken.items()}


def repeats(kind: str, contrast: str) -> Callable[[Path], Truth]:
    """A tower or a facade with equal windows."""

    def make(folder: Path) -> Truth:
        rng = np.random.default_rng(3)
        taken = getattr(repeated, kind)(repeated.CONTRASTS[contrast])
        found = {}
        for k, (grey, c) in enumerate(taken):
            x = c[0] + 1.2 * (-1) ** k
            at = np.array([0, 0, 3.0]) if kind == "tower" else np.array([x, 0, 4.0])
            noisy = np.clip(grey + rng.normal(0, repeated.NOISE, grey.shape), 0, 255).astype(np.uint8)
            found[f"{kind}{contrast}-{k:02d}.jpg"] = (noisy, c, repeated.towards(c, at))
        return rendered(folder, found, repeated.C)

    return make


def scenes(data: Path) -> dict[str, Scene]:
    """All that are there."""
    found: dict[str, Scene] = {}
    fountain = DATA / "fountain-p11"
    if fountain.is_dir():
        found["fountain"] = Scene("fountain", strecha(fountain / "images", "fountain", table(fountain)), 3)
        for name in ("herzjesu-p8", "castle-p19"):
            found[name] = Scene(name, strecha(DATA / name / "images", name, None), 3)
        found["sceaux"] = Scene("sceaux", whole(DATA / "sceaux-castle/images", "sceaux", 0.36), 2)
        found["copr"] = Scene("copr", whole(DATA / "copr-uav/images", "copr", 0.5), 2)
    if (data / "entry-P10").is_dir():
        found["entry"] = Scene("entry", strecha(data / "entry-P10", "entry", published(data / "entry-P10")), 3)
    if (data / "brighton").is_dir():
        found["brighton"] = Scene("brighton", whole(data / "brighton/images", "brighton", 0.3), 2)
    for name in ("temple", "dino"):
        if (data / f"{name}SparseRing").is_dir():
            found[name] = Scene(name, gantry(data / f"{name}SparseRing", name), 2)
    found["portal"] = Scene("portal", portal, 2)
    for kind in doubles.KINDS:
        for equal in (False, True):
            for rich, path in ((True, "chain"), *(((False, "chain"),) if equal else ())):
                name = f"{kind}-{'rich' if rich else 'poor'}-{path}-{'equal' if equal else 'different'}"
                found[name] = Scene(kind, double(kind, path, rich=rich, equal=equal), 0.2 if equal else 1.5)
    for kind in ("tower", "facade"):
        for contrast in ("strong", "weak"):
            found[f"{kind}-{contrast}"] = Scene(f"windows of a {kind}", repeats(kind, contrast), 0.25)
    return found


CHANGES: dict[str, Callable[[np.ndarray], np.ndarray]] = {
    "mirrored": lambda g: g[:, ::-1],
    "cropped": lambda g: g[: int(0.72 * g.shape[0]), int(0.26 * g.shape[1]) :],
    "enlarged": lambda g: cv2.resize(
        g[int(0.12 * g.shape[0]) : int(0.88 * g.shape[0]), int(0.12 * g.shape[1]) : int(0.88 * g.shape[1])],
        g.shape[::-1], interpolation=cv2.INTER_CUBIC,
    ),
    "stretched": lambda g: cv2.resize(
        g[:, int(0.1 * g.shape[1]) : int(0.9 * g.shape[1])], g.shape[::-1], interpolation=cv2.INTER_CUBIC
    ),
}  # fmt: skip
"""Photographs that are changed, in the format of the others where that can be"""
FOREIGN = "foreign"
NOWHERE = ("mirrored", FOREIGN)


def prepared(name: str, scene: Scene, work: Path) -> dict[str, list]:
    """Photographs of a scene in a folder of WORK, and their truth: name to world, centre, rotation."""
    folder = work / "scenes" / name
    kept = folder / "truth.json"
    if kept.exists():
        return json.loads(kept.read_text())
    shutil.rmtree(folder, ignore_errors=True)
    (folder / "photos").mkdir(parents=True)
    truth = scene.make(folder)
    if truth is None:
        camera = folder / "camera.toml"
        done = run(sorted((folder / "photos").iterdir()), folder / "project", camera if camera.exists() else None)
        images = done.adjustment.adjusted.images
        rows = np.flatnonzero(images.oriented)
        truth = {images.file[k]: (images.centre[k], images.rotation[k]) for k in rows.tolist()}
        print(name, "reference of", len(truth), "of", len(done.photos), flush=True)
    found = {n: [name, np.asarray(c).tolist(), np.asarray(R).tolist()] for n, (c, R) in truth.items()}
    kept.write_text(json.dumps(found))
    return found


def changed(path: Path, how: str, folder: Path) -> Path:
    """A photograph, changed; in FOLDER/odd."""
    target = folder / "odd" / f"{how}-{path.name}"
    if not target.exists():
        target.parent.mkdir(exist_ok=True)
        grey = cv2.imread(str(path), cv2.IMREAD_GRAYSCALE)
        cv2.imwrite(str(target), CHANGES[how](grey), [cv2.IMWRITE_JPEG_QUALITY, 95])
    return target


def drawn(names: list[str], rng: np.random.Generator) -> tuple[str, list[str]]:
    """Kind and photographs of a subset."""
    n = len(names)
    size = int(rng.integers(3, min(12, n) + 1))
    kind = str(rng.choice(["contiguous", "sparse", "groups", "random"]))
    if kind == "contiguous":
        return kind, [names[k] for k in sorted((rng.integers(n) + np.arange(size)) % n)]
    if kind == "sparse":
        step = int(rng.integers(2, 4))
        return kind, [names[k] for k in sorted({int(k) % n for k in rng.integers(n) + step * np.arange(size)})]
    if kind == "groups":
        first, second = rng.integers(n), rng.integers(n)
        half = max(2, size // 2)
        each = {int(k) % n for k in (*(first + np.arange(half)), *(second + np.arange(max(2, size - half))))}
        return kind, [names[k] for k in sorted(each)]
    return kind, [names[k] for k in sorted(rng.choice(n, size, replace=False).tolist())]


ODD = 0.2
"""Share of the subsets with photographs that do not belong there or are changed."""


def with_odd(
    chosen: list[str], scene: str, work: Path, others: list[str], rng: np.random.Generator
) -> tuple[str, list[Path], dict[str, str]]:
    """Paths of a subset with odd photographs: kind, paths, and how each odd one was changed."""
    folder = work / "scenes" / scene
    paths = [folder / "photos" / n for n in chosen]
    if rng.random() > ODD:
        return "", paths, {}
    how = str(rng.choice([*CHANGES, FOREIGN, FOREIGN] if len(others) > 1 else [*CHANGES]))
    count = int(rng.choice([1, 1, 2, 3]))
    if how != FOREIGN:
        count = min(count, max(1, (len(paths) - 1) // 2))
        made = {}
        for k in rng.choice(len(paths), count, replace=False).tolist():
            paths[k] = changed(paths[k], how, folder)
            made[paths[k].name] = how
        return how, paths, made
    other = str(rng.choice([o for o in others if o != scene]))
    theirs = sorted((work / "scenes" / other / "photos").iterdir())
    first = int(rng.integers(len(theirs)))
    added = [theirs[(first + k) % len(theirs)] for k in range(count)]
    return how, [*paths, *added], {p.name: FOREIGN for p in added}


def run(paths: list[Path], project: Path, camera: Path | None, *, further: bool = True) -> Orientation:
    """An orientation without precise measurement or vertical; features and pairs are kept in the project."""
    return orient(
        paths, project, OrientOptions(
            precise=False, jobs=1, library=False, feature_count=FEATURES, wide_baselines="own" if further else "none"
        ),
        calibration=() if camera is None else read_cameras(camera), given=Given(up="terrestrial"),
    )  # fmt: skip


def off(block: Block, truth: dict[str, list]) -> dict[str, tuple[float, float]]:
    """Of each oriented photograph, its distance from the truth in extents and its turn in degrees.

    By the similarity through two photographs with which most agree; infinite for those of another world.
    """
    rows = np.flatnonzero(block.images.oriented).tolist()
    names = [block.images.file[k] for k in rows]
    result = dict.fromkeys(names, (np.inf, np.inf))
    o = block.observations
    depth = [
        float(np.median(np.linalg.norm(block.points.xyz[o.point[o.image == k]] - block.images.centre[k], axis=1)))
        if (o.image == k).any() else 0.0
        for k in rows
    ]  # fmt: skip
    centre = block.images.centre[rows]
    span = max((float(np.linalg.norm(a - b)) for a, b in combinations(centre, 2)), default=0.0)
    extent = max(span, float(np.median(depth)))
    best: tuple[int, float] = (0, np.inf)
    for world in {truth[n][0] for n in names if n in truth} - {""}:
        mine = [k for k, n in enumerate(names) if n in truth and truth[n][0] == world]
        own, R = centre[mine], block.images.rotation[[rows[k] for k in mine]]
        true, T = (np.array([truth[names[k]][c] for k in mine]) for c in (1, 2))
        for i, j in combinations(range(len(mine)), 2):
            agree = np.array([i, j])
            for _ in range(4):
                m, turn, shift = _fit(own[agree], R[agree], true[agree], T[agree], extent)
                apart = np.linalg.norm(m * own @ turn.T + shift - true, axis=1) / (m * extent)
                cos = (np.einsum("nij,nij->n", R @ turn.T, T) - 1) / 2
                angle = np.degrees(np.arccos(np.clip(cos, -1, 1)))
                score = (int(((apart <= SHARE) & (angle <= DEGREES)).sum()), float(np.minimum(apart, SHARE).sum()))
                if (-score[0], score[1]) < (-best[0], best[1]):
                    best = score
                    result = dict.fromkeys(names, (np.inf, np.inf))
                    result |= {names[mine[k]]: (float(apart[k]), float(angle[k])) for k in range(len(mine))}
                near = np.flatnonzero((apart <= 2 * SHARE) & (angle <= 2 * DEGREES))
                if len(near) < 2:
                    break
                agree = near
    return result


def _fit(own: np.ndarray, R: np.ndarray, true: np.ndarray, T: np.ndarray, extent: float) -> tuple:
    """Similarity of stations by their centres and the ends of their axes, a third of the extent long."""
    a, b = own - own.mean(axis=0), true - true.mean(axis=0)
    m = float(np.linalg.norm(b) / max(np.linalg.norm(a), 1e-12))
    p = np.concatenate([own[:, None], own[:, None] + extent / 3 * R], axis=1).reshape(-1, 3)
    q = np.concatenate([true[:, None], true[:, None] + m * extent / 3 * T], axis=1).reshape(-1, 3)
    _, turn, _ = similarity(p, q)
    return m, turn, true.mean(axis=0) - m * turn @ own.mean(axis=0)


def kept_part(done: Adjustment, fits: PairFits, truth: dict[str, list]) -> dict[str, np.ndarray]:
    """What predicts, in the raw, and what is true, of one part."""
    block, o = done.adjusted, done.adjusted.observations
    found = off(block, truth)
    rows = np.flatnonzero(block.images.oriented)
    names = [block.images.file[k] for k in rows]
    std = np.full((len(block.images), 6), np.nan) if done.precision is None else done.precision.image_std
    return {
        "names": np.array(names), "rows": rows, "apart": np.array([found[n][0] for n in names]),
        "angle": np.array([found[n][1] for n in names]), "image": o.image, "point": o.point,
        "used": done.image_observations.used, "residuals": done.image_observations.residuals_px.astype(np.float32),
        "redundancy": done.image_observations.redundancy.astype(np.float32),
        "xyz": block.points.xyz.astype(np.float32), "centre": block.images.centre, "rotation": block.images.rotation,
        "std": std, "ends": fits.ends, "matches": fits.matches, "fitting": fits.fitting,
        "sigma0": np.array(done.sigma0),
        "notices": np.array(json.dumps(
            [[n.code, n.variant or "", n.severity.value, [*n.ids, *n.also]] for n in done.notices]
        )),
    }  # fmt: skip


def subsets(work: Path, data: Path, pattern: str, count: int, cpu_s: float) -> None:
    """Orient subsets until there are `count` of each scene, or the time is over."""
    every = scenes(data)
    names = [n for n in every if re.search(pattern, n)]
    truth = dict[str, dict[str, list]]()
    seen: list[PairFits] = []
    original = stage.pair_fits

    def noted(*given) -> PairFits:
        seen.append(original(*given))
        return seen[-1]

    stage.pair_fits = noted
    (work / "draws").mkdir(exist_ok=True)
    for t in range(count):
        for name, k in (
            (n, k) for n in names for k in range(int(t * every[n].subsets), int((t + 1) * every[n].subsets))
        ):
            target = work / "draws" / f"{name}-{k:04d}.npz"
            if target.exists():
                continue
            if resource.getrusage(resource.RUSAGE_SELF).ru_utime > cpu_s:
                return
            if name not in truth:
                truth[name] = prepared(name, every[name], work)
            rng = np.random.default_rng([k, *name.encode()])
            kind, chosen = drawn(sorted(truth[name]), rng)
            how, paths, changes = with_odd(chosen, name, work, [*truth], rng)
            known = {n: v for each in truth.values() for n, v in each.items()}
            known |= {n: known[n.split("-", 1)[1]] for n, h in changes.items() if h not in NOWHERE}
            camera = work / "scenes" / name / "camera.toml"
            seen.clear()
            before = resource.getrusage(resource.RUSAGE_SELF).ru_utime
            try:
                done = run(
                    paths,
                    work / "scenes" / name / "project",
                    camera if camera.exists() else None,
                    further=rng.random() < FURTHER,
                )
            except (NoOrientation, NotSolvable) as error:
                np.savez_compressed(
                    target, about=np.array(json.dumps([name, every[name].group, kind, how, str(error)]))
                )
                continue
            parts = [done.adjustment, *(p.adjustment for p in done.other_components)]
            raw = {
                "about": np.array(json.dumps([name, every[name].group, kind, how, ""])),
                "odd": np.array(json.dumps(changes)),
                "given": np.array([p.name for p in paths]),
            }
            raw["pairs"] = np.array(
                [
                    (p.first, p.second, len(p.matches), p.candidates, p.geometry == "general", bool(p.method))
                    for p in done.pairs
                ],
                int,
            ).reshape(-1, 6)
            raw["photos"] = np.array([p.name for p in done.photos])
            for n, (part, fits) in enumerate(zip(parts, seen, strict=True)):
                raw |= {f"{n}:{key}": v for key, v in kept_part(part, fits, known).items()}
            np.savez_compressed(target, **raw)
            wrong = sum(
                int(((raw[f"{n}:apart"] > SHARE) | (raw[f"{n}:angle"] > DEGREES)).sum()) for n in range(len(parts))
            )
            total = sum(len(raw[f"{n}:names"]) for n in range(len(parts)))
            took = resource.getrusage(resource.RUSAGE_SELF).ru_utime - before
            print(
                f"{target.stem} {kind} {how or '-'}: {total} of {len(paths)} in {len(parts)}, {wrong} wrong, "
                f"{took:.1f} s",
                flush=True,
            )


def stand_in(raw: dict[str, np.ndarray], part: int) -> tuple[SimpleNamespace, PairFits, list[SimpleNamespace]]:
    """What `evidence` asks of a result, from what was kept of a part: other evidence can be tried without orienting."""
    kept = {k.split(":", 1)[1]: v for k, v in raw.items() if k.startswith(f"{part}:")}
    n, p = len(kept["centre"]), len(kept["xyz"])
    rows = kept["used"] & (np.bincount(kept["point"][kept["used"]], minlength=p)[kept["point"]] >= 2)
    sees = csr_array((np.ones(rows.sum(), int), (kept["image"][rows], kept["point"][rows])), shape=(n, p))
    common = np.triu((sees @ sees.T).toarray(), 1)
    pairs = np.argwhere(common >= 6)
    off = np.linalg.norm(kept["xyz"][kept["point"]] - kept["centre"][kept["image"]], axis=1)
    distance = np.array([np.median(off[rows & (kept["image"] == k)]) if (rows & (kept["image"] == k)).any() else np.nan
                         for k in range(n)])  # fmt: skip
    oriented = np.isin(np.arange(n), kept["rows"])
    names = np.full(n, "", dtype=object)
    names[kept["rows"]] = kept["names"]
    block = SimpleNamespace(
        images=SimpleNamespace(oriented=oriented, camera=np.zeros(n, int), centre=kept["centre"], ids=tuple(names)),
        cameras=(SimpleNamespace(is_scene=False),), points=range(p),
        observations=SimpleNamespace(image=kept["image"], point=kept["point"]),
    )  # fmt: skip
    result = SimpleNamespace(
        adjusted=block, image_observations=SimpleNamespace(used=kept["used"]),
        network=SimpleNamespace(pair_images=pairs, pair_points=common[tuple(pairs.T)], distance=distance),
        precision=SimpleNamespace(image_std=kept["std"]),
    )  # fmt: skip
    notices = [
        SimpleNamespace(code=code, severity=Severity(s), ids=tuple(ids), also=())
        for code, _, s, ids in json.loads(str(kept["notices"]))
    ]
    return result, PairFits(ends=kept["ends"], matches=kept["matches"], fitting=kept["fitting"]), notices


@dataclass(frozen=True)
class Sample:
    """Photographs of all subsets."""

    evidence: np.ndarray
    wrong: np.ndarray
    group: np.ndarray
    """of scenes"""
    subset: np.ndarray
    kind: np.ndarray
    """what is odd about it or its subset"""
    scenes: int


def sample(work: Path) -> Sample:
    """What was drawn."""
    evidence, wrong, group, subset, kind = [], [], [], [], []
    there = set[str]()
    for k, file in enumerate(sorted((work / "draws").glob("*.npz"))):
        raw = dict(np.load(file))
        scene, of, _, how, failed = json.loads(str(raw["about"]))
        if failed:
            continue
        there.add(scene)
        odd = json.loads(str(raw["odd"]))
        for part in range(sum(key.endswith(":names") for key in raw)):
            table = ws.evidence(*stand_in(raw, part))[raw[f"{part}:rows"]]
            off = (raw[f"{part}:apart"] > SHARE) | (raw[f"{part}:angle"] > DEGREES)
            names = raw[f"{part}:names"].tolist()
            for n, (row, bad) in enumerate(zip(table, off.tolist(), strict=True)):
                if np.isfinite(row).all():
                    evidence.append(row)
                    wrong.append(bad)
                    group.append(of)
                    subset.append(k)
                    beside = (
                        f"beside {how}" if how else "equal parts" if "equal" in scene or "windows" in of else "usual"
                    )
                    kind.append(odd.get(names[n], beside))
    each = (np.array(v) for v in (evidence, wrong, group, subset, kind))
    return Sample(*each, scenes=len(there))


PRIOR = 3.0
"""Standard deviation of a coefficient beforehand, of standardised evidence"""
RANGE = (0.005, 0.995)
"""Quantiles of the evidence beyond which nothing is extrapolated"""


def fitted(s: Sample, rows: np.ndarray) -> ws.Model:
    """The model of some photographs.

    Coefficients are not negative: each piece of evidence makes a wrong station likelier.  Photographs of one subset are
    wrong together: the covariance is that of sums over subsets (Huber 1967; Liang and Zeger 1986).
    """
    X, y = s.evidence[rows], s.wrong[rows].astype(float)
    low, high = np.quantile(X, RANGE, axis=0)
    X = np.clip(X, low, high)
    mean, scale = X.mean(axis=0), np.maximum(X.std(axis=0), 1e-6)
    x = np.column_stack([np.ones(len(X)), (X - mean) / scale])
    prior = np.append(0.0, np.full(X.shape[1], PRIOR**-2.0))

    def loss(b: np.ndarray) -> tuple[float, np.ndarray]:
        t = x @ b
        return float(np.logaddexp(0, t).sum() - y @ t + 0.5 * prior @ b**2), x.T @ (expit(t) - y) + prior * b

    bounds = [(None, None), *[(0, None)] * X.shape[1]]
    b = minimize(loss, np.append(-3.0, np.full(X.shape[1], 0.1)), jac=True, bounds=bounds, method="L-BFGS-B").x
    free = np.append(True, b[1:] > 1e-6)
    q = expit(x @ b)
    H = np.linalg.inv(((x.T * (q * (1 - q))) @ x + np.diag(prior))[np.ix_(free, free)])
    score = np.zeros((s.subset.max() + 1, free.sum()))
    np.add.at(score, s.subset[rows], (x * (y - q)[:, None])[:, free])
    C = np.zeros((len(b), len(b)))
    C[np.ix_(free, free)] = H @ (score.T @ score) @ H
    T = np.diag(np.append(1.0, 1 / scale))
    T[0, 1:] = -mean / scale
    return ws.Model(low=low, high=high, coefficients=T @ b, covariance=T @ C @ T.T)


def interval(k: int, n: int) -> list[float]:
    """95 % of Clopper and Pearson (1934)."""
    return [
        0.0 if k == 0 else float(betaincinv(k, n - k + 1, 0.025)),
        1.0 if k == n else float(betaincinv(k + 1, n - k, 0.975)),
    ]


EDGES = (0.0, 0.003, 0.005, 0.02, 0.05, 0.15, 0.5, 1.0)


def reliability(p: np.ndarray, s: Sample, rows: np.ndarray) -> list[dict]:
    """Stated and found shares of wrong stations, by classes of what is stated."""
    found = []
    for low, high in pairwise(EDGES):
        mine = rows & (p >= low) & (p < high)
        n, k = int(mine.sum()), int(s.wrong[mine].sum())
        if n:
            found.append({
                "class": [low, high], "photographs": n, "stated": round(float(p[mine].mean()), 4), "wrong": k,
                "found": round(k / n, 4), "interval": [round(v, 4) for v in interval(k, n)],
                "subsets_with_wrong": len(np.unique(s.subset[mine & s.wrong])),
            })  # fmt: skip
    return found


def judged(work: Path) -> dict:
    """Each group of scenes by a model of the others; the model of all."""
    s = sample(work)
    p = np.full(len(s.wrong), np.nan)
    for group in np.unique(s.group):
        mine = s.group == group
        p[mine] = ws.probabilities(s.evidence[mine], fitted(s, ~mine))
    every = np.ones(len(p), bool)
    model = fitted(s, every)
    alarm = p > ws.LIMIT
    rows = {str(k): s.kind == k for k in np.unique(s.kind)}
    return {
        "photographs": len(p), "wrong": int(s.wrong.sum()), "subsets": len(np.unique(s.subset)), "scenes": s.scenes,
        "reliability": reliability(p, s, every),
        "by_kind": {
            k: {"photographs": int(m.sum()), "wrong": int(s.wrong[m].sum()), "expected": round(float(p[m].sum()), 1),
                "named": int((alarm & m & s.wrong).sum())}
            for k, m in rows.items()
        },
        "by_group": {
            str(g): {"photographs": int((m := s.group == g).sum()), "wrong": int(s.wrong[m].sum()),
                     "expected": round(float(p[m].sum()), 1)}
            for g in np.unique(s.group)
        },
        "limit": ws.LIMIT,
        "false_alarms": {"right": int((~s.wrong).sum()), "named": int((alarm & ~s.wrong).sum()),
                         "interval": interval(int((alarm & ~s.wrong).sum()), int((~s.wrong).sum()))},
        "named_of_wrong": round(float(alarm[s.wrong].mean()), 3),
        "model": {
            name: np.round(getattr(model, name), 5).tolist() for name in ("low", "high", "coefficients", "covariance")
        },
    }  # fmt: skip


def main() -> int:
    """Run."""
    parser = argparse.ArgumentParser()
    parser.add_argument("what", choices=["draw", "fit"])
    parser.add_argument("work", type=Path)
    parser.add_argument("--data", type=Path, default=HERE / "work/published")
    parser.add_argument("--scenes", default="")
    parser.add_argument("--subsets", type=int, default=40)
    parser.add_argument("--cpu", type=float, default=1e9)
    a = parser.parse_args()
    if a.what == "draw":
        subsets(a.work, a.data, a.scenes, a.subsets, a.cpu)
        return 0
    found = judged(a.work)
    RESULTS.write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")
    print(json.dumps({k: v for k, v in found.items() if k != "model"}, indent=1))
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
