"""From raybundle's cameras to forward cameras and back, each with the largest deviation in pixels; undistortion.

The Brown and fisheye models correct the measured point, forward cameras distort the ideal point; the one is
not exactly the inverse of the other.  The parameters of the other direction are fitted by least squares over
a grid on the whole image format, and what the fit leaves is measured on a finer grid and returned.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from raybundle.block import Block, Camera
from raybundle.cameras.forward_camera import STEP, TERMS, ForwardCamera, distorted, forward_rays, ideal_points
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.least_squares import added, minimum
from raybundle.sensors import sensor_models

NOMINAL_SIDE_MM = 36.0
"""Longer side of the format where the size of a pixel is not known; results in pixels do not depend on it."""
LIMIT_PX = 0.1
"""A conversion that deviates by more than this is refused unless an approximation is asked for: the precision of a
measured image point, beyond which the misfit of the camera is the largest error of a block."""
CLOSE_PX = 0.01
"""A fit with fewer parameters is taken if it deviates by no more than this."""
LEAST_INVERTIBLE = 0.5
FLAT = 1e-4
"""A step that lowers the sum of squares by a smaller share is the last: rational distortions have long flat valleys."""
FULL = ("fx", "fy", "cx", "cy", "k1", "k2", "p1", "p2", "k3", "d1", "d2", "d3")
OPENCV = FULL[:8]
FISHEYE = ("fx", "fy", "cx", "cy", "k1", "k2", "k3", "k4")


@dataclass(frozen=True, slots=True, kw_only=True)
class ForwardFit:
    """A forward camera and how well it stands for the camera it was made from."""

    camera: ForwardCamera
    deviation_px: float
    """Largest distance between the images of one ray, over the whole format."""
    rms_px: float = 0.0
    """Root mean square of these distances."""
    covered: float = 1.0
    """Share of the format in which the camera it was made from has rays."""


@dataclass(frozen=True, slots=True, kw_only=True)
class CameraFit:
    """A camera of raybundle and how well it stands for the forward camera it was made from."""

    camera: Camera
    deviation_px: float
    """Largest distance between the images of one ray, over the part of the format that has rays."""
    covered: float
    """Share of the format in which the foreign distortion has an inverse."""
    rms_px: float = 0.0
    """Root mean square of these distances."""


LARGEST_AFFINITY = 0.9
"""Ratio of the scales of the axes, less one: pixels of scanners reach 0.5."""
TALLEST = 20
"""Beyond this ratio of height to width the rows of a grid stand less densely than its columns."""


def grid_px(width_px: int, height_px: int, columns: int = 31) -> Array:
    """Pixels (2, n) of a regular grid over the whole format, edges included."""
    rows = max(3, min(round(columns * height_px / width_px), TALLEST * columns))
    x, y = np.meshgrid(np.linspace(0, width_px, columns), np.linspace(0, height_px, rows))
    return np.stack([x.ravel(), y.ravel()])


def parameter_vector(camera: Camera) -> Array:
    """(k,) interior orientation in the order of the model's parameters."""
    return np.array([float(camera.values.get(s, 0.0)) for s in sensor_models[camera.model].symbols])


def camera_rays(camera: Camera, pixels: Array) -> Array:
    """Unit viewing directions (3, n) in the sensor frame of pixels (2, n).

    raises  InputError for a model whose rays do not pass through one point of the sensor frame
    """
    if camera.model == "panorama":
        raise InputError("camera.panorama_not_supported", camera=camera.id)
    image = camera.image_from_pixel(pixels.T).T
    return sensor_models[camera.model].ray(image, parameter_vector(camera))


def interiors(block: Block) -> tuple[tuple[Camera, ...], Index]:
    """Cameras with one interior orientation each, and the position (n,) of every image in them.

    An image with an interior orientation of its own gets a camera of its own, CAMERA-IMAGE.
    """
    cameras = list(block.cameras)
    index = np.array(block.images.camera, np.int32)
    for k, own in sorted(block.images.interior.items()):
        base = block.cameras[int(index[k])]
        index[k] = len(cameras)
        cameras.append(replace(base, id=f"{base.id}-{block.images.ids[k]}", values={**base.values, **own}))
    used = np.unique(index)
    position = np.full(len(cameras), -1, np.int32)
    position[used] = np.arange(len(used))
    return tuple(cameras[k] for k in used.tolist()), position[index]


def opencv_fit(camera: Camera) -> ForwardFit:
    """The simplest OpenCV camera within 0.01 px: pinhole, 4 or 8 coefficients; for a fisheye OpenCV's fisheye."""
    exact = exact_forward(camera)
    if exact is None and camera.sensor.all_round:
        return forward_fit(camera, FISHEYE, projection="equidistant")
    if exact is not None and not (exact.s1 or exact.s2 or exact.s3 or exact.s4):
        return ForwardFit(camera=exact, deviation_px=0.0)
    short, full = terms_for(camera, OPENCV), terms_for(camera, FULL)
    fit = forward_fit(camera, short)
    return fit if fit.deviation_px <= CLOSE_PX else min(fit, forward_fit(camera, full), key=lambda f: f.deviation_px)


def terms_for(camera: Camera, terms: Sequence[str]) -> tuple[str, ...]:
    """The terms that a camera needs: one principal distance, and no skew, where it has neither affinity nor shear."""
    square = camera.pixel_mm[0] == camera.pixel_mm[1] and not camera.values.get("A") and not camera.values.get("S")
    return tuple(t for t in terms if not (square and t in {"fy", "skew"}))


def pinhole_of(camera: Camera) -> ForwardCamera | None:
    """The exact pinhole of a Brown camera without distortion and shear; None for any other."""
    values = camera.values
    if camera.model != "brown" or any(values.get(s, 0.0) for s in ("K1", "K2", "K3", "P1", "P2", "S")):
        return None
    return _first_guess(camera, "central")


def exact_forward(camera: Camera) -> ForwardCamera | None:
    """The forward camera that images as one of ours does, term by term; None for models of the other direction.

    `EXACT` models distort the ideal point, as forward cameras do; y points up with us, so terms of y change their sign.
    """
    twin = EXACT.get(camera.model)
    if twin is None:
        return pinhole_of(camera)
    values = {s: float(camera.values.get(s, 0.0)) for s in sensor_models[camera.model].symbols}
    terms = {t: sign * values[s] for s, (t, sign) in twin.terms.items()}
    guess = _first_guess(replace(camera, values={**values, "A": 0.0}), twin.projection)
    # A stretches y with these, x with `brown`
    width, height = camera.pixel_mm
    return replace(guess, fx=values["c"] / width, fy=values["c"] * (1 + values.get("A", 0.0)) / height, **terms)


def exact_measured(forward: ForwardCamera, blank: Camera, model: str) -> Camera | None:
    """The camera of one of the `EXACT` models that images as a forward camera does; None where that has other terms.

    blank  the format and pixel size wanted, with the principal point
    """
    twin = EXACT[model]
    known = {t for t, _ in twin.terms.values()}
    others = [t for t in TERMS[5:] if t not in known]
    if forward.projection != twin.projection or any(abs(getattr(forward, t)) > ROUNDED for t in others):
        return None
    if abs(forward.skew) > ROUNDED * forward.fx:
        return None
    symbols = sensor_models[model].symbols
    width, height = blank.pixel_mm
    stretch = forward.fy * height / (forward.fx * width) - 1
    values = {"c": forward.fx * width, "A": stretch, **{s: float(blank.values.get(s, 0.0)) for s in ("x0", "y0")}}
    values |= {s: sign * float(getattr(forward, t)) for s, (t, sign) in twin.terms.items()}
    lost = [s for s in values if s not in symbols and abs(values[s]) > ROUNDED * abs(values["c"])]
    return None if lost else replace(blank, model=model, values={s: values[s] for s in symbols})


ROUNDED = 1e-14
"""What a term that a model has not may be; of a length, the share of the camera constant: rounding"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Twin:
    """How a model of ours is a forward camera, term by term."""

    terms: Mapping[str, tuple[str, int]]
    """symbol -> term of the forward camera, and 1, or -1 where y up changes its sign"""
    projection: Literal["central", "equidistant"] = "central"


_RATIONAL = {
    "k1": ("k1", 1), "k2": ("k2", 1), "k3": ("k3", 1), "k4": ("d1", 1), "k5": ("d2", 1), "k6": ("d3", 1),
    "p1": ("p1", -1), "p2": ("p2", 1),
}  # fmt: skip
EXACT: Mapping[str, Twin] = {
    "radial": Twin(terms={"k1": ("k1", 1), "k2": ("k2", 1)}),
    "rational": Twin(terms=_RATIONAL),
    "thin_prism": Twin(
        terms={**_RATIONAL, "s1": ("s1", 1), "s2": ("s2", 1), "s3": ("s3", -1), "s4": ("s4", -1)},
    ),
    "kannala_brandt": Twin(terms={k: (k, 1) for k in ("k1", "k2", "k3", "k4")}, projection="equidistant"),
}
"""Our models that are forward cameras, the simplest first"""


def _first_guess(camera: Camera, projection: Literal["central", "equidistant"]) -> ForwardCamera:
    width, height = camera.pixel_mm
    c, x0, y0, A = (float(camera.values.get(s, 0.0)) for s in ("c", "x0", "y0", "A"))
    if not (c > 0 and abs(A) < LARGEST_AFFINITY):
        raise InputError("camera.no_lens", camera=camera.id, c_mm=c, A=A)
    return ForwardCamera(
        width_px=camera.width_px,
        height_px=camera.height_px,
        projection=projection,
        fx=c / (1 + A) / width,
        fy=c / height,
        cx=camera.width_px / 2 + x0 / width,
        cy=camera.height_px / 2 - y0 / height,
    )


def rays_of(camera: Camera | ForwardCamera, pixels: Array) -> Array:
    """Unit viewing directions (3, n) in the sensor frame of pixels (2, n); NaN where a forward camera has none."""
    return camera_rays(camera, pixels) if isinstance(camera, Camera) else forward_rays(camera, pixels)


def _named(camera: Camera | ForwardCamera) -> str:
    return f"camera {camera.id}" if isinstance(camera, Camera) else "the camera"


def _known(rays: Array, name: str) -> Mask:
    """(n,) where the rays (3, n) of a grid exist; raises InputError where it is less than half of the format."""
    known: Mask = np.asarray(np.isfinite(rays).all(axis=0))
    if (covered := float(known.mean())) < LEAST_INVERTIBLE:
        raise InputError("camera.distortion_not_invertible", name=name, covered=covered, least=LEAST_INVERTIBLE)
    return known


def forward_fit(
    camera: Camera | ForwardCamera,
    terms: Sequence[str],
    *,
    projection: Literal["central", "equidistant"] = "central",
    centred: bool = False,
) -> ForwardFit:
    """The forward camera with these terms free that images the camera's rays best, over the whole format.

    terms    names out of `forward_camera.TERMS`; without "fy" the two principal distances are the same
    centred  the principal point is the image centre, unless it is among the terms
    raises   InputError where the format sees 90 degrees off the axis and the projection is central
    """
    pixels = grid_px(camera.width_px, camera.height_px)
    fine = grid_px(camera.width_px, camera.height_px, 58)
    rays, rays_fine = rays_of(camera, pixels), rays_of(camera, fine)
    seen, seen_fine = _known(rays, _named(camera)), _known(rays_fine, _named(camera))
    pixels, fine = pixels[:, seen], fine[:, seen_fine]
    ideal, ideal_fine = ideal_points(rays[:, seen], projection), ideal_points(rays_fine[:, seen_fine], projection)
    if not (np.isfinite(ideal).all() and np.abs(ideal).max() < 50):
        raise InputError("camera.wider_than_projection", name=_named(camera))
    exact = exact_forward(camera) if isinstance(camera, Camera) else None
    if exact is not None and exact.projection == projection and _has_only(exact, terms, centred=centred):
        return ForwardFit(camera=exact, deviation_px=0.0, covered=float(seen_fine.mean()))
    guess = _first_guess(camera, projection) if isinstance(camera, Camera) else camera
    start = np.where(np.isin(TERMS, ("fx", "fy", "cx", "cy")), guess.vector, 0.0)
    if centred:
        start[2:4] = camera.width_px / 2, camera.height_px / 2
    free = [TERMS.index(t) for t in terms]
    one_scale = "fy" not in terms

    def full(x: Array) -> Array:
        vector = start.astype(x.dtype)
        vector[free] = x
        if one_scale:
            vector[1] = vector[0]
        return vector

    def residual_and_jacobian(x: Array) -> tuple[Array, Array]:
        columns: list[Array] = []
        for k in range(len(x)):
            step = x.astype(complex)
            step[k] += STEP * 1j
            columns.append(np.imag(distorted(ideal, full(step))).ravel() / STEP)
        return (distorted(ideal, full(x)) - pixels).ravel(), np.stack(columns, axis=1)

    vector = full(minimum(residual_and_jacobian, start[free], added, damping=1e-3, enough=FLAT).values)
    values = dict(zip(TERMS, vector.tolist(), strict=True))
    fitted = ForwardCamera(width_px=camera.width_px, height_px=camera.height_px, projection=projection, **values)
    with np.errstate(all="ignore"):
        deviation = np.linalg.norm(distorted(ideal_fine, vector) - fine, axis=0)
    return ForwardFit(
        camera=fitted,
        deviation_px=float(deviation.max()),
        rms_px=float(np.sqrt(np.mean(deviation**2))),
        covered=float(seen_fine.mean()),
    )


def _has_only(forward: ForwardCamera, terms: Sequence[str], *, centred: bool) -> bool:
    """Whether a camera needs no other terms; without "fy" the principal distances are the same."""
    middle = {"cx": forward.width_px / 2, "cy": forward.height_px / 2} if centred else {}
    fixed = {"fy": forward.fx, **middle, **dict.fromkeys(TERMS[4:], 0.0)}
    return all(t in terms or getattr(forward, t) == value for t, value in fixed.items())


def camera_from_forward(
    forward: ForwardCamera, id_: str, *, pixel_mm: float | None = None, where: str = ""
) -> CameraFit:
    """The camera that stands for a forward camera: brown or fisheye by a fit, or a model of the same terms.

    An equidistant camera of k1 to k4 is `kannala_brandt`, exactly.
    pixel_mm  size of a (square) pixel; None: a nominal one, 36 mm over the longer side
    where     words for the message of an error
    raises    InputError where the distortion has no inverse over half the format
    Interior orientations come as "auto": free as far as an adjustment can determine them.
    """
    pixel = pixel_mm or NOMINAL_SIDE_MM / max(forward.width_px, forward.height_px)
    central = forward.projection == "central"
    blank = Camera(
        id=id_,
        model="brown" if central else "fisheye",
        width_px=forward.width_px,
        height_px=forward.height_px,
        pixel_mm=(pixel if central else pixel * forward.fy / forward.fx, pixel),
        values={},
        estimate="auto",
    )
    blank = replace(blank, values=_central_values(forward, blank))
    if forward.is_pinhole:
        return CameraFit(camera=blank, deviation_px=0.0, covered=1.0)
    if (exact := exact_measured(forward, blank, "kannala_brandt")) is not None:
        _known(rays_of(forward, grid_px(forward.width_px, forward.height_px)), f"{where}camera {id_}")
        return CameraFit(camera=exact, deviation_px=0.0, covered=1.0)
    fit = measured_fit(forward, blank, _needed(forward, blank), where=where)
    if fit.deviation_px <= CLOSE_PX:
        return fit
    if _is_radial(forward):
        values = {"c": forward.fx * pixel, "k1": forward.k1, "k2": forward.k2}
        return CameraFit(camera=replace(blank, model="radial", values=values), deviation_px=0.0, covered=1.0)
    twins = (exact_measured(forward, blank, name) for name in EXACT if name != "radial")
    exact = next((t for t in twins if t is not None), None)
    return fit if exact is None else CameraFit(camera=exact, deviation_px=0.0, covered=1.0)


def _central_values(forward: ForwardCamera, blank: Camera) -> dict[str, float]:
    """The interior orientation without distortion; different principal distances are an affinity, or the pixel's."""
    width, height = blank.pixel_mm
    values = dict.fromkeys(sensor_models[blank.model].symbols, 0.0)
    values["c"] = forward.fy * height
    values["x0"] = (forward.cx - forward.width_px / 2) * width
    values["y0"] = -(forward.cy - forward.height_px / 2) * height
    if "A" in values:
        values["A"] = forward.fy / forward.fx - 1
    return values


def _is_radial(forward: ForwardCamera) -> bool:
    centre = (forward.cx, forward.cy) == (forward.width_px / 2, forward.height_px / 2)
    others = forward.vector[[4, *range(7, len(TERMS))]]
    return forward.projection == "central" and centre and forward.fx == forward.fy and not others.any()


def _needed(forward: ForwardCamera, blank: Camera) -> list[str]:
    """The symbols that stand for what the forward camera has."""
    free = ["c"]
    others = forward.vector[TERMS.index("k5") :].any()
    if others or any((forward.k1, forward.k2, forward.k3, forward.k4, forward.d1, forward.d2, forward.d3)):
        free += ["K1", "K2", "K3"]
    if others or forward.p1 or forward.p2:
        free += ["x0", "y0", "P1", "P2"]
    affine = (("A", forward.fx != forward.fy), ("S", forward.skew))
    return free + [s for s, given in affine if (given or others) and s in blank.values]


def measured_fit(source: Camera | ForwardCamera, blank: Camera, free: Sequence[str], *, where: str = "") -> CameraFit:
    """A camera that corrects the measured point, fitted to the rays of any camera over the whole format.

    blank   the model, format and pixel size wanted, with the values to begin with
    free    symbols that are fitted; the others keep their values
    raises  InputError where the source has rays over less than half of the format
    """
    model = sensor_models[blank.model]
    values = blank.values
    pixels = grid_px(blank.width_px, blank.height_px)
    rays = rays_of(source, pixels)
    known = _known(rays, f"{where}camera {blank.id}")
    covered = float(known.mean())
    order = [model.symbols.index(s) for s in free]
    x = np.array([values[s] for s in model.symbols])
    per_mm = 1 / np.array(blank.pixel_mm)

    at, ray = pixels[:, known], rays[:, known]

    def residual_and_jacobian(part: Array) -> tuple[Array, Array]:
        full = x.copy()
        full[order] = part
        image = blank.image_from_pixel(at.T).T
        g, J = model.condition_and_jacobian(*image, *ray, *full)
        by_image = np.linalg.inv(np.moveaxis(np.broadcast_to(J[:, :2], (2, 2, g.shape[1])), 2, 0))
        g_px = np.einsum("nij,jn,i->in", by_image, g, per_mm)
        J_px = np.einsum("nij,jkn,i->ikn", by_image, np.broadcast_to(J, (2, J.shape[1], g.shape[1]))[:, 5:], per_mm)
        return g_px.ravel(), np.moveaxis(J_px[:, order], 1, 2).reshape(-1, len(order))

    x[order] = minimum(residual_and_jacobian, x[order], added, damping=1e-3, enough=FLAT).values
    fine = grid_px(blank.width_px, blank.height_px, 58)
    fine_rays = rays_of(source, fine)
    seen = np.isfinite(fine_rays).all(axis=0)
    at, ray = fine[:, seen], fine_rays[:, seen]  # what the function looks at from here on
    left = np.linalg.norm(residual_and_jacobian(x[order])[0].reshape(2, -1), axis=0)
    fitted = dict(zip(model.symbols, x.tolist(), strict=True))
    return CameraFit(
        camera=replace(blank, model=model.name, values=fitted),
        deviation_px=float(left.max()),
        covered=covered,
        rms_px=float(np.sqrt(np.mean(left**2))),
    )
