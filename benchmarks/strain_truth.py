"""Digital image correlation (`raybundle strain`) against known displacements: bias, noise, standard deviations.

    python benchmarks/strain_truth.py [DICE/tests/regression]

Figures go into benchmarks/results/strain_truth.json.

interpolation  speckles of three sizes, shifted by parts of a pixel in the Fourier domain: largest bias of these windows
               and of those with cubic convolution (as tie points are matched), noise over the bound of Cramer and Rao
rendered       rotation, strain, light, noise of one image, compression, large motions, a crack: chi-square of
               displacements and of strains
challenge      images of the DIC challenge (Reu et al. 2018) in the regression tests of DICe: samples 14 and 15 with
               commanded displacements, which are functions of the place after the motion; sample 12, a real tensile
               test, beside the solutions of DICe that are stored there

The bound is that of the adjusted model: affine shape, brightness, contrast and slopes of the light; gradients without
noise, noise of both images.
"""

import argparse
import json
import resource
import sys
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))
from tests.matching.specimen import deformed, found, image, motion, moved  # noqa: E402
from tests.matching.test_subsets import cracked, developed  # noqa: E402

from raybundle.io.photos.photo import read_grey, read_photo  # noqa: E402
from raybundle.matching.least_squares import Outcome, WindowOptions, match_windows  # noqa: E402
from raybundle.matching.spline_pictures import Picture  # noqa: E402
from raybundle.matching.subset_noise import overlap_correlation  # noqa: E402
from raybundle.matching.subsets import State, SubsetGrid, follow, window_options  # noqa: E402
from raybundle.metrology.strain import strain_field  # noqa: E402
from raybundle.numerics.statistics import mahalanobis2  # noqa: E402

SHIFTS = (0.1, 0.25, 0.5, 0.75, 0.9)


def bound(gx, gy, grey, xy, half, variance):
    """(n, 2) least variances of displacements, of noise of this variance in the difference of two images."""
    side = np.arange(-half, half + 1)
    v, u = (a.ravel().astype(float) for a in np.meshgrid(side, side, indexing="ij"))
    at = np.floor(xy).astype(int)
    least = np.empty((len(xy), 2))
    for k, (x, y) in enumerate(at):
        window = np.s_[y - half : y + half + 1, x - half : x + half + 1]
        a, b, t = (g[window].ravel() for g in (gx, gy, grey))
        t = t / t.std()
        J = np.stack([a, b, a * u, a * v, b * u, b * v, np.ones_like(t), t, t * u, t * v], axis=1)
        J[:, 2:] /= np.abs(J[:, 2:]).max(axis=0)
        least[k] = variance * np.diag(np.linalg.inv(J.T @ J))[:2]
    return least


def spectrum_of(size, radius, seed):
    f = np.fft.fftfreq(size)
    fx, fy = np.meshgrid(f, f)
    blob = np.exp(-2 * (np.pi * np.hypot(fx, fy) * radius) ** 2)
    spectrum = np.fft.fft2(np.random.default_rng(seed).normal(size=(size, size))) * blob
    return spectrum / np.fft.ifft2(spectrum).real.std(), fx, fy


def interpolation(size=512, half=15):
    result = {}
    for radius in (0.6, 1.0, 1.6):
        spectrum, fx, fy = spectrum_of(size, radius, 3)
        inverse = lambda s: np.fft.ifft2(s).real  # noqa: E731
        truth, gx, gy = (35 * inverse(s) for s in (spectrum, 2j * np.pi * fx * spectrum, 2j * np.pi * fy * spectrum))
        free = np.zeros((size, size), bool)
        free[16:-16, 16:-16] = True
        for noise in (0.0, 3.0):
            bias, convolved, square, least, chi = [], [], [], [], []
            for k, d in enumerate(SHIFTS):
                rng = np.random.default_rng(k)
                pair = (128 + truth, 128 + 35 * inverse(spectrum * np.exp(-2j * np.pi * (fx * d + fy * 0.3))))
                a, b = (np.clip(np.round(p + rng.normal(0, noise, p.shape)), 0, 255).astype(np.uint8) for p in pair)
                grid = SubsetGrid.of(free, 16, half)
                f = follow(Picture.of(a, 1), Picture.of(b, 2), grid, window_options(half, quadratic=False))
                error = f.xy_px - grid.xy_px - [d, 0.3]
                bias.append(np.abs(error.mean(axis=0)).max())
                square.append((error**2).mean(axis=0))
                chi.append(mahalanobis2(error, f.cov_px2).mean() / 2)
                least.append(bound(gx, gy, truth, grid.xy_px, half, 2 * (noise**2 + 1 / 12)).mean(axis=0))
                wide = WindowOptions(half=half, sigma=1e6, loose=1e3, iterations=40, step=1e-4)
                unit = np.tile(np.eye(2), (len(grid.xy_px), 1, 1))
                m = match_windows(
                    a.astype(np.uint16) * 256, b.astype(np.uint16) * 256, grid.xy_px, grid.xy_px, unit, wide
                )
                good = m.outcome == Outcome.MATCHED
                convolved.append(np.abs((m.xy_px - grid.xy_px)[good].mean(axis=0) - [d, 0.3]).max())
            result[f"radius {radius} px, noise {noise}"] = {
                "largest_bias_px": max(bias), "largest_bias_by_cubic_convolution_px": max(convolved),
                "noise_over_bound": float(np.sqrt(np.mean(square) / np.mean(least))), "chi2": float(np.mean(chi)),
            }  # fmt: skip
    return result


RENDERED = {
    "rotation 10 deg": (motion(10.0, shift=(3.2, -7.1)), {}),
    "strain 5 %": (motion(strain=(0.05, -0.02, 0.01), shift=(1.3, 0.1)), {}),
    "darker by a third": (motion(strain=(0.004, -0.001, 0.0), shift=(0.6, 0.4)), {"level": 80.0, "contrast": 22.0}),
    "noise 2 and 6": (motion(shift=(0.25, 0.5)), {"noise": 6.0}),
    "turned by 175 deg": (motion(175.0), {}),
    "moved by 26 px": (motion(shift=(23.4, -11.7)), {}),
    "JPEG 95": (motion(shift=(0.37, 0.61)), {}),
    "JPEG 80": (motion(shift=(0.37, 0.61)), {}),
    "mosaic of colours": (motion(shift=(0.37, 0.61)), {}),
}


def rendered(seeds=4, step=10, half=10, gauge=2):
    result = {}
    near = overlap_correlation(window_options(half, quadratic=False), step, 2 * gauge)
    for name, ((F, shift), light) in RENDERED.items():
        displacement, strain, bias, share = [], [], [], []
        E = (F.T @ F - np.eye(2)) / 2
        for seed in range(seeds):
            pair = image(2 * seed), deformed(2 * seed + 1, F, shift, **light)
            if name.startswith(("JPEG", "mosaic")):
                pair = [developed(name.removeprefix("JPEG ").partition(" ")[0], p) for p in pair]
            grid, f = found(*pair, step=step, half=half)
            good = f.state == State.FOLLOWED
            error = (f.xy_px - moved(grid.xy_px, F, shift))[good]
            e = strain_field(f.xy_px - grid.xy_px, f.cov_px2, grid.cell, grid.shape, float(step), gauge, near)
            k = np.isfinite(e.strain[:, 0])
            displacement.append(mahalanobis2(error, f.cov_px2[good]).mean() / 2)
            strain.append(mahalanobis2(e.strain[k] - [E[0, 0], E[1, 1], E[0, 1]], e.cov[k]).mean() / 3)
            bias.append(error.mean(axis=0))
            share.append(good.mean())
        result[name] = {
            "followed": float(np.mean(share)), "bias_px": float(np.abs(np.mean(bias, axis=0)).max()),
            "chi2": float(np.mean(displacement)), "chi2_strain": float(np.mean(strain)),
        }  # fmt: skip
    for opening in (0.15, 0.5, 1.0, 4.0):
        grid, f = found(image(1), cracked(2, opening), step=5, half=half)
        x, y = (grid.xy_px - [170.0, 150.0]).T
        across, good = (np.abs(y) < half) & (x < -30), f.state == State.FOLLOWED
        away = (np.abs(y) > half + 4) & (x < -30)
        result[f"crack of {2 * opening} px"] = {
            "followed_beside": float(good[away].mean()), "followed_across": float(good[across].mean())
        }  # fmt: skip
    return result


def grey_of(path):
    return read_grey(read_photo(path))


def judged(f, grid, truth, rows, least):
    """Figures of some subsets: largest bias of a tenth of the columns or rows, noise over the bound, chi-square."""
    good = (f.state == State.FOLLOWED) & rows
    error = (f.xy_px - grid.xy_px - truth)[good]
    return {
        "subsets": int(good.sum()), "followed": float((f.state == State.FOLLOWED)[rows].mean()),
        "bias_px": np.abs(error.mean(axis=0)).max(),
        "noise_over_bound": float(np.sqrt((error**2).mean() / least[good].mean())),
        "chi2": mahalanobis2(error, f.cov_px2[good]).mean() / 2, "noise": np.nanmedian(f.noise, axis=0).tolist(),
    }  # fmt: skip


def gradients(picture):
    """Of the spline of an image at its pixels."""
    from scipy.ndimage import convolve1d, spline_filter

    c = spline_filter(picture.astype(float), 3, mode="mirror")
    slope, value = [0.5, 0, -0.5], [1 / 6, 2 / 3, 1 / 6]
    return tuple(
        convolve1d(convolve1d(c, slope, axis=k, mode="mirror"), value, axis=1 - k, mode="mirror") for k in (1, 0)
    )


def sample_14(folder):
    command = np.loadtxt(folder / "command.csv", delimiter=",")
    reference = grey_of(folder / "images/Sample14 Reference.tif")
    gx, gy = gradients(reference)
    result = {}
    for half, shape in ((10, "affine"), (15, "affine"), (15, "quadratic")):
        grid = SubsetGrid.of(np.ones(reference.shape, bool), 10, half)
        least = bound(gx, gy, reference.astype(float), grid.xy_px, half, 25.0)
        for k, name in ((1, "L1"), (3, "L3"), (5, "L5")):
            target = Picture.of(grey_of(folder / f"images/Sample14 {name} Amp0.1b.tif"), 2)
            f = follow(Picture.of(reference, 1), target, grid, window_options(half, quadratic=shape == "quadratic"))
            u = np.interp(f.xy_px[:, 0] - 0.5, command[:, 0], command[:, k])
            found = judged(f, grid, np.stack([u, 0 * u], axis=1), np.ones(len(u), bool), least)
            error = (f.xy_px - grid.xy_px)[:, 0] - u
            good = f.state == State.FOLLOWED
            if shape == "quadratic":
                found.pop("noise_over_bound")  # the bound is that of affine shapes
            # a shape that is too stiff shows as a share of the commanded displacement
            found["share_lost"] = float(-(error[good] @ u[good]) / (u[good] @ u[good]))
            column = grid.cell[good, 1] // 10
            found["bias_of_100_columns_px"] = float(
                max(abs(error[good][column == c].mean()) for c in np.unique(column))
            )
            result[f"14 {name}, window {2 * half + 1}, {shape}"] = found
    return result


def sample_15(folder, half=15):
    command = np.loadtxt(folder / "command.csv", delimiter=",")
    reference = grey_of(folder / "images/Reference.tif")
    grid = SubsetGrid.of(np.ones(reference.shape, bool), 15, half)
    gx, gy = gradients(reference)
    result = {}
    for k in range(8):
        name = f"P200_K{50 * (k + 1)}_N2"
        f = follow(Picture.of(reference, 1), Picture.of(grey_of(folder / f"images/{name}.tif"), 2), grid,
                   window_options(half, quadratic=False))  # fmt: skip
        v = np.interp(f.xy_px[:, 1] - 0.5, command[:, 0], command[:, k + 1])
        # where an affine shape of this window errs by less than 0.001 px: curvature times a mean of squares of places
        curvature = np.gradient(np.gradient(command[:, k + 1]))
        reach = np.arange(-half, half + 1)
        rows = np.clip(np.floor(grid.xy_px[:, 1]).astype(int)[:, None] + reach - 5, 0, len(command) - 1)
        smooth = np.abs(curvature[rows]).max(axis=1) * half**2 / 6 < 0.001
        noise = float(np.nanmedian((f.noise**2).sum(axis=1)))
        least = bound(gx, gy, reference.astype(float), grid.xy_px, half, noise)
        result[f"15 {name}"] = judged(f, grid, np.stack([0 * v, v], axis=1), smooth, least)
    return result


def sample_12(folder):
    """Differences to DICe (windows of 27 px, shift and normal strains, KEYS_FOURTH), by columns of displacements."""
    first, before, result = Picture.of(grey_of(folder / "images/oht_cfrp_00.tiff"), 1), None, {}
    for k in range(1, 12):
        table = np.genfromtxt(folder / f"gold/DICe_solution_{k:02d}.txt", delimiter=",", skip_header=21)
        cell = np.stack([np.unique(table[:, c], return_inverse=True)[1] for c in (1, 0)], axis=1)
        grid = SubsetGrid(xy_px=table[:, :2] + 0.5, cell=cell, shape=tuple(cell.max(axis=0) + 1), step=35)
        target = Picture.of(grey_of(folder / f"images/oht_cfrp_{k:02d}.tiff"), 2)
        before = follow(first, target, grid, window_options(13, quadratic=False), before)
        apart = before.xy_px - grid.xy_px - table[:, 2:4]
        std = np.sqrt(np.nanmedian(np.trace(before.cov_px2, axis1=1, axis2=2)) / 2)
        result[f"12, load {k}"] = {
            "followed": float((before.state == State.FOLLOWED).mean()), "stated_px": float(std),
            "rms_to_dice_px": np.sqrt(np.nanmean(apart**2, axis=0)).tolist(),
            "largest_to_dice_px": float(np.nanmax(np.abs(apart))),
        }  # fmt: skip
    return result


def main():
    """Print and store the figures."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("data", type=Path, nargs="?", help="tests/regression of github.com/dicengine/dice")
    data = parser.parse_args().data
    figures = {"interpolation": interpolation(), "rendered": rendered()}
    if data is not None:
        samples = ((sample_14, "14_vsg"), (sample_15, "15"), (sample_12, "12"))
        figures["challenge"] = {k: v for of, name in samples for k, v in of(data / f"dic_challenge_{name}").items()}
    for part, rows in figures.items():
        print(part)
        for name, row in rows.items():
            print(f"  {name}: " + ", ".join(f"{k} {np.round(v, 4)}" for k, v in row.items()))
    used = [resource.getrusage(w) for w in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    figures["cpu_seconds"] = sum(u.ru_utime + u.ru_stime for u in used)
    out = ROOT / "benchmarks/results/strain_truth.json"
    out.write_text(json.dumps(figures, indent=1, default=float) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
