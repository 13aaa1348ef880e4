"""Targets: precision against the bound of Cramér and Rao, true covariances, covered dots, recall, wrong codes, speed.

    python benchmarks/target_centres.py centres [runs]     centres: rms, bound, chi-square
    python benchmarks/target_centres.py codes [shots]      recall; wrong codes with a tenth of the ring hidden
    python benchmarks/target_centres.py covered [dots]     dots on which something lies, as a whole and by what is free
    python benchmarks/target_centres.py photographs        ../shared/data: panel of targets, photographs without, speed
    python benchmarks/target_centres.py constants [dots]   what each constant of the judgement of covered dots decides

Each writes its part of benchmarks/results/target_centres.json.

The photographs are rendered by tests/targets/render.py, which samples the true perspective image of a disc and does not
share the model of the fit.  The bound is that of the fit's ten unknowns over the whole picture, for white noise.
"""

import json
import os
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
from PIL import Image
from scipy.stats import chi2, kstest

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from tests.targets import covered_dots, render  # noqa: E402
from tests.targets.covered_dots import measured  # noqa: E402
from tests.targets.render import shot  # noqa: E402

from raybundle.targets.centre import DotOptions, blurred_ellipse, fit_dots, triangle_from_ellipse  # noqa: E402
from raybundle.targets.detect import DetectionOptions, detect_targets, find_targets  # noqa: E402
from raybundle.targets.families import families  # noqa: E402
from raybundle.targets.partial_dots import measure_dots  # noqa: E402

NOISE, CONTRAST, LOW = 2.0, 160.0, 40.0
RADII = (5, 8, 15)
TILTS = (0, 30, 45, 60)
BLURS = (0.5, 0.7, 1.0, 1.5, 2.0)
SLOPES = (0.0, 0.3)
"""Relative change of the light across the picture."""
RIVAL = {5: 0.0089, 8: 0.0060, 15: 0.0041}
"""A dual conic, frontal, blur 0.7 px [px]."""


def bound(s, blur):
    """Least standard deviation of a coordinate [px], mean over x and y; noise and rounding."""
    v = np.array(
        [*s.centre, *triangle_from_ellipse(s.ellipse[None])[0], np.hypot(blur, np.sqrt(1 / 12)), LOW, CONTRAST, 0, 0]
    )
    h, w = s.image.shape
    x, y = np.arange(w) + 0.5, np.arange(h) + 0.5
    f, derivatives = blurred_ellipse(v, x, y)
    dx, dy = np.meshgrid(x - v[0], y - v[1])
    level = LOW + CONTRAST * f
    J = np.stack([*(CONTRAST * derivatives), np.ones_like(f), f, level * dx, level * dy]).reshape(10, -1)
    N = J @ J.T / (NOISE**2 + 1 / 12) + np.diag([0] * 8 + [1 / DotOptions().slope ** 2] * 2)
    return np.sqrt(np.trace(np.linalg.inv(N)[:2, :2]) / 2)


def cell(rng, radius, tilt, blur, slope, runs):
    """Errors (n, 2), Mahalanobis squares (n,), bounds (n,) and dots that were lost."""
    errors, squares, bounds, lost = [], [], [], 0
    for _ in range(runs):
        turn = rng.uniform(0, 2 * np.pi)
        s = shot(
            rng, radius, np.radians(tilt), size=2 * (int(radius * 2.2) + 14), blur=blur,
            slope=(slope * np.cos(turn), slope * np.sin(turn)),
        )  # fmt: skip
        d = detect_targets(s.image, None, DetectionOptions(polarity="light"))
        near = np.flatnonzero(np.hypot(*(d.xy_px - s.centre).T) < 1)
        if len(near) != 1:
            lost += 1
            continue
        e = d.xy_px[near[0]] - s.centre
        errors.append(e)
        squares.append(e @ np.linalg.solve(d.covariance[near[0]], e))
        bounds.append(bound(s, blur))
    return np.array(errors).reshape(-1, 2), np.array(squares), np.array(bounds), lost


def speed(rng, radius):
    """Centres a second on one core."""
    s = shot(rng, radius, 0.4, size=int(5 * radius + 20))
    n = 200
    start = np.tile(s.centre + 0.1, (n, 1)), np.tile(s.ellipse, (n, 1, 1)), np.full(n, 1.5)
    image = s.image.astype(np.uint16)
    began = time.process_time()
    fit_dots(image, *start)
    return n / (time.process_time() - began)


def centres(runs=10):
    """Errors over tilts, blurs and slopes of the light."""
    rng = np.random.default_rng(1)
    result = {"runs": runs, "noise": NOISE, "contrast": CONTRAST, "frontal": {}, "all": {}, "centres_per_second": {}}
    print("radius  frontal rms (rival)   all: rms  bound  ratio  NIS (2)   p   lost  worst cell")
    for radius in RADII:
        e, *_ = cell(rng, radius, 0, 0.7, 0.0, 8 * runs)
        frontal = float(np.sqrt(np.mean(e**2)))
        cells = {
            (t, b, g): cell(rng, radius, t, b, g, runs) for t in TILTS for b in BLURS for g in SLOPES
        }  # fmt: skip
        errors, squares, bounds = (np.concatenate([c[k] for c in cells.values()]) for k in range(3))
        lost = sum(c[3] for c in cells.values())
        rms, least = float(np.sqrt(np.mean(errors**2))), float(np.sqrt(np.mean(bounds**2)))
        ratios = {k: np.sqrt(np.mean(c[0] ** 2) / np.mean(c[2] ** 2)) for k, c in cells.items() if len(c[0])}
        worst = max(ratios, key=ratios.get)
        p = float(kstest(squares, chi2(2).cdf).pvalue)
        result["frontal"][radius] = {"rms_px": frontal, "rival_px": RIVAL[radius]}
        result["all"][radius] = {
            "rms_px": rms, "bound_px": least, "mean_bound_px": float(bounds.mean()), "ratio": rms / least,
            "mahalanobis": float(squares.mean()), "p": p, "lost": lost, "dots": len(squares) + lost,
        }  # fmt: skip
        result["centres_per_second"][radius] = speed(rng, radius)
        print(
            f"{radius:4d}    {frontal:.4f} ({RIVAL[radius]:.4f})       {rms:.4f}  {least:.4f}  {rms / least:.2f}   "
            f"{squares.mean():.2f}   {p:.2f}  {lost:3d}  {worst} {ratios[worst]:.2f}"
        )
    print("centres a second:", {k: round(v) for k, v in result["centres_per_second"].items()})
    return result


HIDDEN = 0.1
"""Share of the ring that a grey wedge hides."""
NETWORK_PX = 10.0
"""A read stays if the place that the network predicts for its number is so near; places are farther apart."""


def one_code(rng, family, hidden):
    """A rendered target: its id, what was read there."""
    k = int(rng.integers(len(family)))
    begin = rng.uniform(0, 2 * np.pi)
    s = shot(
        rng, rng.uniform(4, 12), np.radians(rng.uniform(0, 60)), bits=family.bits, code=int(family.codes[k]),
        ring=family.ring, blur=rng.uniform(0.4, 1.0), inverse=bool(rng.integers(2)), slope=rng.uniform(-0.3, 0.3, 2),
        hidden=(begin, begin + 2 * np.pi * HIDDEN, rng.uniform(0.3, 0.7)) if hidden else None,
    )  # fmt: skip
    return int(family.ids[k]), detect_targets(s.image, family, DetectionOptions(uncoded="none")).id.tolist()


def codes(shots=1000):
    """Recall, and wrong codes before and after the network has been asked.

    The network: a field that holds every target of the family once, its orientation known from other targets to 3 px
    in each coordinate; a read whose number belongs farther away than NETWORK_PX is dropped.
    """
    render.FINE = 5
    rng = np.random.default_rng(2)
    result = {"shots": shots, "hidden": HIDDEN}
    for name in ("aicon12", "aicon14", "aicon20", "agisoft12", "agisoft14"):
        family = families[name]
        side = int(np.ceil(np.sqrt(len(family))))
        place = {int(i): 60.0 * np.array(divmod(n, side)) for n, i in enumerate(family.ids)}
        part = {}
        for hidden in (False, True) if family.bits < 16 else (False,):
            right = wrong = after = 0
            for _ in range(shots):
                true, read = one_code(rng, family, hidden)
                right += true in read
                bad = [i for i in read if i != true]
                wrong += len(bad)
                at = place[true] + rng.normal(0, 3, 2)
                after += sum(np.hypot(*(place[i] - at)) < NETWORK_PX for i in bad)
            part["hidden" if hidden else "whole"] = {"right": right, "wrong": wrong, "wrong_after_network": after}
        result[name] = part
        print(name, part, flush=True)
    return result


def covered(count=560):
    """Dots on three quarters of which something lies: fitted as a whole, and by what is free; and what whole ones lose.

    Not counted as measured are those that are refused.  A centre is far where it is 4 standard deviations off.
    """
    result = {"dots": count}
    for name, fit in (("whole", fit_dots), ("free", measure_dots)):
        began = time.process_time()
        part, square, outcome, precision = measured(fit, count, 2).T
        fine, result[name] = outcome == 0, {"seconds_with_rendering": time.process_time() - began}
        for low, high in ((0, 0), (0.05, 0.15), (0.15, 0.3), (0.3, 0.45), (0.05, 0.45)):
            some = (part == 0) if high == 0 else (part > low) & (part <= high)
            ok = some & fine
            result[name][f"{low}-{high}"] = {
                "dots": int(some.sum()), "measured": int(ok.sum()), "chi2_per_degree": float(square[ok].mean() / 2),
                "far": int((square[ok] > 16).sum()), "far_expected": float(ok.sum() * chi2(2).sf(16)),
                "median_sigma_px": float(np.median(precision[ok])),
            }  # fmt: skip
            print(name, low, high, result[name][f"{low}-{high}"], flush=True)
    rng = np.random.default_rng(4)
    for radius in (5, 8):
        shots = [shot(rng, radius, 0.4, size=int(4.4 * radius + 16)) for _ in range(300)]
        image, ellipse = np.hstack([s.image for s in shots]), np.array([s.ellipse for s in shots])
        xy = np.array([np.add(s.centre, (k * s.image.shape[1] + 0.1, 0.1)) for k, s in enumerate(shots)])
        seconds = {}
        for fit in (fit_dots, measure_dots, fit_dots, measure_dots):
            began = time.process_time()
            for _ in range(3):
                fit(image, xy, ellipse, np.full(len(shots), 1.8))
            seconds[fit.__name__] = time.process_time() - began
        result[f"time_ratio_of_whole_dots_{radius}"] = seconds["measure_dots"] / seconds["fit_dots"]
        print("time of whole dots, radius", radius, result[f"time_ratio_of_whole_dots_{radius}"])
    return result


def photographs():
    """Reads on the panel, false targets on photographs without, speed; each photograph by one of two threads."""
    import cv2

    cv2.setNumThreads(1)
    folder = ROOT.parent / "shared" / "data" / "photos"
    panel = [grey(f) for f in sorted((folder / "cern-targets" / "images").glob("*.tif"))]
    family, options = families["aicon14"], DetectionOptions(uncoded="none")
    megapixels = sum(i.size for i in panel) / 1e6
    result = {"load": os.getloadavg()[0]}
    with ThreadPoolExecutor(2) as pool:
        began = time.perf_counter()
        list(pool.map(lambda i: find_targets(i, family, options), panel))
        result["find_megapixels_per_second"] = megapixels / (time.perf_counter() - began)
        began = time.perf_counter()
        found = list(pool.map(lambda i: detect_targets(i, family, options), panel))
        result["find_and_measure_megapixels_per_second"] = megapixels / (time.perf_counter() - began)
    ids = [set(d.id.tolist()) for d in found]
    result["reads"] = sum(map(len, ids))
    result["not_on_the_panel"] = sum(len(i - set(range(2, 75))) for i in ids)
    result["twice"] = sum(len(d) for d in found) - result["reads"]
    false = {}
    for name in ("castle-p19/images/0010.jpg", "sceaux-castle/images/100_7105.JPG", "fountain-p11/images/0005.jpg"):
        image = grey(folder / name)
        false[name] = {f.name: len(detect_targets(image, f, options)) for f in families.values()}
    result["false"] = false
    print(result)
    return result


CONSTANTS = {"NO_OUTLINE": (0.0, 0.4, 0.8, 0.95), "LOST": (1.5, 2.0, 4.5, 6.0, 1e9)}
"""Values tried of each constant of `targets.partial_dots`, one at a time, beside its own."""


def constants(count=400):
    """What becomes of rendered dots, as targets and as spots, and of spots in photographs, for each value.

    chi2_per_degree  of those measured; far beyond 4 standard deviations; spots  dots left in photographs of no targets
    """
    from raybundle.targets import partial_dots as module

    rng = np.random.default_rng(90)
    drawn = list(covered_dots.dots(count, 91))
    starts = [(c.shot.centre + rng.normal(0, 0.15, 2), c.shot.ellipse * (1 + rng.normal(0, 0.05))) for c in drawn]
    part = np.array([c.part for c in drawn])
    folder = ROOT.parent / "shared" / "data" / "photos"
    empty = [grey(f) for n in ("castle-p19", "sceaux-castle", "fountain-p11", "herzjesu-p8")
             for f in sorted((folder / n / "images").iterdir())[:2]]  # fmt: skip
    panel = [grey(f) for f in sorted((folder / "cern-targets" / "images").glob("*.tif"))[:2]]

    def tried():
        row = {}
        for name, surely in (("targets", None), ("spots", np.zeros(1, bool))):
            square, fine = np.full(count, np.nan), np.zeros(count, bool)
            for k, (c, (xy, C)) in enumerate(zip(drawn, starts, strict=True)):
                d = measure_dots(c.shot.image, xy[None], C[None], np.array([2.0]), surely=surely)
                fine[k] = d.outcome[0] == 0
                if fine[k]:
                    e = d.xy_px[0] - c.shot.centre
                    square[k] = e @ np.linalg.solve(d.cov_px2[0], e)
            for label, some in (("whole", part == 0), ("covered", part > 0)):
                ok = some & fine
                row[f"{name}_{label}"] = {
                    "dots": int(some.sum()), "measured": int(ok.sum()),
                    "chi2_per_degree": round(float(square[ok].mean() / 2), 3), "far": int((square[ok] > 16).sum()),
                }  # fmt: skip
        row["spots_in_photographs"] = sum(len(detect_targets(i, None)) for i in empty)
        row["dots_on_panel"] = sum(len(detect_targets(i, None)) for i in panel)
        return row

    result = {"dots": count, "as_they_are": tried()}
    print("as they are", result["as_they_are"], flush=True)
    for name, values in CONSTANTS.items():
        own = getattr(module, name)
        result[name] = {"own": own}
        for value in values:
            setattr(module, name, value)
            result[name][str(value)] = tried()
            print(name, value, result[name][str(value)], flush=True)
        setattr(module, name, own)
    return result


def grey(path):
    with Image.open(path) as image:
        return np.array(image.convert("L"))


def main():
    part = sys.argv[1] if len(sys.argv) > 1 else "centres"
    number = [int(n) for n in sys.argv[2:3]]
    result = {
        "centres": centres,
        "codes": codes,
        "covered": covered,
        "photographs": photographs,
        "constants": constants,
    }[part](*number)
    out = ROOT / "benchmarks" / "results" / "target_centres.json"
    whole = json.loads(out.read_text()) if out.is_file() else {}
    whole = {k: whole[k] for k in ("centres", "codes", "covered", "photographs", "constants") if k in whole} | {
        part: result
    }
    out.write_text(json.dumps(whole, indent=1) + "\n")


if __name__ == "__main__":
    main()
