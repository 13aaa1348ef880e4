"""Resolution helps natural features; targets are limited by what no resolution mends."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from scipy.ndimage import gaussian_filter

from raybundle.matching.least_squares import NOISE_SIGMA_PX, Outcome, WindowOptions, match_windows, with_noisy_gradients
from raybundle.numerics.arrays import Array
from raybundle.planning.rules.networks import on_site
from raybundle.planning.rules.rule import Chart, Curve, Evidence, Figures, Limits, Rule, Words
from raybundle.planning.rules.sources import FRASER_1984
from raybundle.targets.centre import blurred_ellipse, fit_dots

STEPS = (1, 2, 4)
"""Pixels of the finer image on one of the coarsest."""
BLUR, NOISE = 0.7, 2.0
"""Standard deviations of optics and pixel together [px], and of a grey value."""
CONTRAST, DIAMETER = 160.0, 8.0
"""Of the target: grey values; pixels of the coarsest image."""
TEXTURE = 25.0
"""Standard deviation of the texture's grey values in the coarsest image."""
REST = 0.012
"""What the bundle left of targets on a printed panel where grey values promised 0.004 px (explanation/targets) [px]."""
GROUND = 4.0
"""Of the plain ground around a target [px]."""
WINDOWS, DOTS = 36, 24
WAVES = 160


@dataclass(frozen=True, slots=True, kw_only=True)
class Texture:
    """Plane waves in random directions, as many in each octave with as much power: detail at all scales alike."""

    wave: Array
    """(k, 2) [cycles / pixel of the coarsest image]"""
    phase: Array
    """(k,)"""

    @classmethod
    def drawn(cls, rng: np.random.Generator, coarsest: float, finest: float) -> Texture:
        """Waves of lengths between these [pixels of the coarsest image]."""
        f = np.exp(rng.uniform(np.log(1 / coarsest), np.log(1 / finest), WAVES))
        turn = rng.uniform(0, 2 * np.pi, WAVES)
        return cls(
            wave=f[:, None] * np.stack([np.cos(turn), np.sin(turn)], axis=1), phase=rng.uniform(0, 2 * np.pi, WAVES)
        )

    def seen(self, step: int, side: int, shift: Array) -> Array:
        """(side, side) what an image of pixels 1 / step as large shows of it, by `shift` (2,) of its own pixels."""
        x = (np.arange(side) + 0.5 - side / 2) / step
        amplitude = np.exp(-2 * (np.pi * BLUR / step) ** 2 * np.sum(self.wave**2, axis=1))
        phase = self.phase - 2 * np.pi * (self.wave @ (shift / step))
        right, down = (np.exp(2j * np.pi * np.outer(x, self.wave[:, k])) for k in (0, 1))
        # no matrix product: for so small ones its threads wait longer for each other than the sum takes
        waves = np.einsum("yk,xk->yx", down * (amplitude * np.exp(1j * phase)), right)
        return np.real(waves) * np.sqrt(2 / WAVES)


class Resolution(Rule):
    """Measured with the matching and the fit of targets that raybundle uses, on rendered grey values."""

    name = "resolution"
    title = "Resolution"
    order = 5
    sources = (FRASER_1984,)
    words = Words(
        statement="Higher resolution makes natural features more accurate, targets less so.",
        network="No network but what enters it: sigma of an image point from the covariance that least-squares "
        "matching of 17 × 17 px windows, and the fit of a round target, state (both tested against their errors). "
        "The same object, by pixels of 1, 1/2 and 1/4 of the coarsest; blur 0.7 px, noise 2 grey values at each. "
        "Textures: waves with detail at all scales, or with none finer than two coarse pixels, 25 grey values; a "
        "target of 8 coarse pixels, contrast 160. Sigma on the object is sigma in pixels times the pixel, and every "
        "standard deviation of a network is proportional to it.",
        finding="Twice the resolution makes a texture with detail at all scales {natural:.2f} times as accurate on "
        "the object: sigma stays at {natural_px:.3f} px. Where the finest detail is resolved already, it brings "
        "{soft:.2f} times. Of the target grey values alone promise {target:.2f} times (the edge is longer by two "
        "and sharper by two: √8), from {target_px:.4f} px on. But that is below what else moves targets: a printed "
        "panel left {rest:.3f} px where 0.004 px were promised ([targets](targets.md)), of paper and "
        "lens, which finer pixels do not mend. With that remainder, held fixed on the object, twice the resolution "
        "brings {limited:.2f} times.",
        ends="The rule holds of targets because of what is not their noise; by noise alone it would be the other "
        "way round. The remainder is one measured case, and that it stays the same on the object is assumed. Pixels "
        "made smaller on the same sensor collect less light: with noise doubled at each halving, the texture gains "
        "nothing ({photons:.2f} times).",
        costs="Pixels half as large are four times as many to store and to match. With the same camera it is half the "
        "distance: four times as many photographs of the same surface, {more:.0f} minutes more where there were eight.",
    )
    example = """import numpy as np
from raybundle.planning.rules.resolution import fitted

for resolution in (1, 2, 4):
    error, covariance = fitted(resolution)  # of round targets: errors and what the fit states of them
    sigma = np.sqrt(np.median(np.trace(covariance, axis1=1, axis2=2) / 2))
    print(f"sigma {sigma:.4f}")
"""
    limits: ClassVar[Mapping[str, Limits]] = {
        "natural": (1.8, 2.2),  # alike at all scales: the same picture in every pixel size, so the factor of the pixel
        "soft": (0.7, 1.5),  # the window shrinks on the object as the gradients do in the image
        "target": (2.5, 3.3),  # sqrt(8) = 2.83, and more by the ground, whose share falls as the target grows
        "limited": (1.0, 1.2),
        "photons": (0.7, 1.2),
    }

    def evidence(self) -> Evidence:
        """Standard deviations at three resolutions."""
        step = np.array(STEPS, float)
        natural = np.array([_matched(s, finest=0.25) for s in STEPS])
        soft = np.array([_matched(s, finest=2.0) for s in STEPS])
        dark = np.array([_matched(s, finest=0.25, noise=NOISE * s) for s in STEPS])
        target = np.array([_fitted(s) for s in STEPS])
        limited = np.hypot(target / step, REST)
        on_object = {
            "texture, detail at all scales": natural / step, "texture, none below 2 px": soft / step,
            "texture, less light on smaller pixels": dark / step, "target, grey values alone": target / step,
            "target, with what paper and lens leave": limited,
        }  # fmt: skip
        in_pixels = (natural, soft, dark, target, limited * step)
        return Evidence(
            charts=(
                Chart(
                    title="On the object", x_label="resolution against the coarsest", y_label="sigma [coarsest px]",
                    logarithmic=(True, True), curves=tuple(Curve(name=n, x=step, y=y) for n, y in on_object.items()),
                ),
            ),
            figures=Figures(
                header=("image point", "sigma at 1 [px]", "at 2 [px]", "at 4 [px]", "gain of 1 to 2", "of 2 to 4"),
                rows=tuple(
                    (name, *px, o[0] / o[1], o[1] / o[2])
                    for (name, o), px in zip(on_object.items(), in_pixels, strict=True)
                ),
                decimals=(4, 4, 4, 2, 2),
            ),
            numbers={
                "natural": _gain(natural / step), "natural_px": natural[0], "soft": _gain(soft / step),
                "target": _gain(target / step), "target_px": target[0], "rest": REST, "limited": _gain(limited),
                "photons": _gain(dark / step),
                "more": on_site(np.zeros((8 * (STEPS[1] ** 2 - 1), 3))).minutes,
            },
        )  # fmt: skip


def _levels(grey: Array) -> Array:
    """Grey values by hundredths as whole numbers, so that rounding is none of the noise."""
    return np.rint(100 * np.clip(grey, 0, 600)).astype(np.uint16)


def _gain(sigma: Array) -> float:
    """Of one doubling, mean over the steps."""
    return float((sigma[0] / sigma[-1]) ** (1 / np.log2(STEPS[-1] / STEPS[0])))


def matched(step: int, finest: float, noise: float) -> tuple[Array, Array]:
    """Errors (n, 2) and stated covariances (n, 3) [px] of windows matched at a resolution."""
    rng = np.random.default_rng([step, round(1000 * finest), round(10 * noise)])
    options, side = WindowOptions(), 29
    first, second, place, true = list[Array](), list[Array](), list[Array](), list[Array]()
    for k in range(WINDOWS):
        texture = Texture.drawn(rng, coarsest=64.0, finest=finest)
        shift = rng.uniform(-0.5, 0.5, 2)
        for part, at in ((first, np.zeros(2)), (second, shift)):
            grey = 128 + TEXTURE * texture.seen(step, side, at) + rng.normal(0, noise, (side, side))
            part.append(_levels(gaussian_filter(grey, NOISE_SIGMA_PX)))
        place.append(np.array([side * k + side / 2, side / 2]))
        true.append(place[-1] + shift)
    reference, image, xy, wanted = np.hstack(first), np.hstack(second), np.array(place), np.array(true)
    found = match_windows(reference, image, xy, wanted, np.tile(np.eye(2), (WINDOWS, 1, 1)), options)
    found = with_noisy_gradients(found, xy, options)
    good = found.outcome == Outcome.MATCHED
    return (found.xy_px - wanted)[good], found.cov_px2[good]


def _matched(step: int, finest: float, noise: float = NOISE) -> float:
    """Standard deviation of a coordinate [px], median over the windows."""
    return float(np.sqrt(np.median(matched(step, finest, noise)[1][:, :2].mean(axis=1))))


def fitted(step: int) -> tuple[Array, Array]:
    """Errors (n, 2) and stated covariances (n, 2, 2) [px] of a target of fixed size at a resolution."""
    rng = np.random.default_rng([7, step])
    radius = DIAMETER / 2 * step
    side = 2 * int(np.ceil(2.2 * radius)) + 8
    error, stated = list[Array](), list[Array]()
    for _ in range(DOTS):
        centre = side / 2 + rng.uniform(-0.5, 0.5, 2)
        v = np.array([*centre, radius, 0.0, radius, BLUR, 40.0, CONTRAST, 0.0, 0.0])
        at = np.arange(side) + 0.5
        grey = 40 + CONTRAST * blurred_ellipse(v, at, at)[0] + rng.normal(0, NOISE, (side, side))
        window = np.array([1 + GROUND / radius])
        dots = fit_dots(_levels(grey), centre[None], np.eye(2)[None] * radius**2, window)
        assert dots.measured.all()
        error.append(dots.xy_px[0] - centre)
        stated.append(dots.cov_px2[0])
    return np.array(error), np.array(stated)


def _fitted(step: int) -> float:
    """Standard deviation of a coordinate [px], median over the targets."""
    return float(np.sqrt(np.median(np.trace(fitted(step)[1], axis1=1, axis2=2) / 2)))
