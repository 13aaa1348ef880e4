"""Rational polynomial coefficients (RPC00B): a scene's image point as two ratios of cubic polynomials.

With L, P, H the longitude, latitude and height, centred and scaled,

    v = line numerator / line denominator,  u = sample numerator / sample denominator
    x = x_offset + x_scale u,               y = y_offset + y_scale v

and 20 terms in each polynomial, in the order 1 L P H LP LH PH L2 P2 H2 PLH L3 LP2 LH2 L2P P3 PH2 L2H P2H H3
(STDI-0002, appendix E).  Files count pixels from the centre of the first one or from 1; here, as everywhere in
raybundle, the centre of the first pixel is 0.5, 0.5, and the readers convert.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from importlib import import_module
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from raybundle.errors import InputError, NoConvergence
from raybundle.numerics.arrays import Array, Mask
from raybundle.numerics.geodesy import LocalPlace, metres_per_geographic
from raybundle.numerics.places import Local, Place
from raybundle.scenes.bias import BiasKind, bias_design, bias_slope
from raybundle.scenes.observed import Observed
from raybundle.scenes.rpc_ground import LEAST_DENOMINATOR, ground_points

POLYNOMIALS = ("line_num_coeff", "line_den_coeff", "samp_num_coeff", "samp_den_coeff")

TERMS = (
    "1", "L", "P", "H", "LP", "LH", "PH", "LL", "PP", "HH",
    "LPH", "LLL", "LPP", "LHH", "LLP", "PPP", "PHH", "LLH", "PPH", "HHH",
)  # fmt: skip
"""The first ten are all monomials up to degree two, in which the derivatives of all twenty are written."""
SHAPES = {
    "coefficients": (4, 20),
    "ground_offset": (3,),
    "ground_scale": (3,),
    "image_offset": (2,),
    "image_scale": (2,),
}
CHUNK = 4096
"""Points evaluated at once, so that all terms stay in the processor's cache."""
FAR_RANGES, FAR_M = 10.0, 20e3
"""Heights farther from the middle than so many times half the range, and so many metres, have no ground points."""
NO_PLACE = 5.0
"""Points farther from the middle than so many times the range have no place in the scene."""
RANGE = 1.1
"""Normalised coordinates up to which an RPC is taken to hold; vendors fit it for -1 to 1."""


def _derivative_maps() -> Array:
    """(3, 20, 10): the derivative of each term by L, P, H in the first ten terms."""
    quadratic = {t: k for k, t in enumerate(TERMS[:10])}
    maps = np.zeros((3, 20, 10))
    for axis, letter in enumerate("LPH"):
        for k, term in enumerate(TERMS):
            if letter in term:
                rest = term.replace(letter, "", 1) or "1"
                maps[axis, k, quadratic[rest]] = term.count(letter)
    return maps


_DERIVATIVES = _derivative_maps()


@dataclass(frozen=True, slots=True, kw_only=True)
class Rpc:
    """A scene's rational polynomials; the order of coordinates is longitude, latitude [deg], height [m]; x, y [px]."""

    coefficients: Array
    """(4, 20) line numerator, line denominator, sample numerator, sample denominator."""
    ground_offset: Array
    """(3,) [deg, deg, m]"""
    ground_scale: Array
    """(3,)"""
    image_offset: Array
    """(2,) x, y [px]; the centre of the first pixel is 0.5, 0.5."""
    image_scale: Array
    """(2,)"""
    err_bias_m: float | None = None
    """Standard deviation of the error that is common to the scene, on the ground [m] (ERR_BIAS, 68 %)."""
    err_rand_m: float | None = None
    """Standard deviation of the error that changes within the scene [m] (ERR_RAND, 68 %)."""

    def __post_init__(self) -> None:
        """Refuse shapes and numbers that make no RPC."""
        for name, shape in SHAPES.items():
            values = getattr(self, name)
            if np.shape(values) != shape or not np.isfinite(values).all():
                raise InputError("rpc.wrong_shape", name=name, shape=np.shape(values), needed=shape)
        for name in ("ground_scale", "image_scale"):
            if not (getattr(self, name) > 0).all():
                raise InputError("rpc.not_positive", name=name, values=getattr(self, name).tolist())
        lon, lat = self.ground_offset[:2].tolist()
        if abs(lat) > 90 or abs(lon) > 360:
            raise InputError("rpc.centre_out_of_range", latitude_deg=lat, longitude_deg=lon)
        zero = np.flatnonzero(self.coefficients[[1, 3], 0] == 0)
        if len(zero):
            which = ("line", "sample")[int(zero[0])]
            raise InputError("rpc.zero_denominator", axis=which)

    def project(self, geographic: Array) -> Array:
        """Image points (n, 2) [px] of longitude, latitude [deg], height [m] (n, 3).

        raises  InputError where a denominator vanishes, far outside the scene or in a damaged RPC
        """
        geographic = _rows(geographic)
        xy = np.empty((len(geographic), 2))
        for part, (values, _) in self._evaluated(geographic, partials=False):
            xy[part] = self._image(values[2] / values[3], values[0] / values[1])
        return xy

    def project_with_partials(self, geographic: Array) -> tuple[Array, Array]:
        """Image points (n, 2) [px] and their derivatives (n, 2, 3) by longitude, latitude [1/deg] and height [1/m].

        raises  InputError as `project`
        """
        geographic = _rows(geographic)
        xy, by_ground = np.empty((len(geographic), 2)), np.empty((2, 3, len(geographic)))
        to_image = self.image_scale[:, None] / self.ground_scale
        for part, (values, slopes) in self._evaluated(geographic, partials=True):
            for axis, top in ((0, 2), (1, 0)):  # x is the sample, y the line
                inverse = 1 / values[top + 1]
                ratio = values[top] * inverse
                xy[part, axis] = self.image_offset[axis] + self.image_scale[axis] * ratio
                slope = by_ground[axis, :, part]
                np.multiply(ratio, slopes[:, top + 1], out=slope)
                np.subtract(slopes[:, top], slope, out=slope)
                slope *= inverse
                slope *= to_image[axis][:, None]
        return xy, np.moveaxis(by_ground, 2, 0)

    def localise(self, xy_px: Array, height: Array | float) -> Array:
        """Longitude, latitude, height (n, 3) of image points (n, 2) at heights (n,) or one height [m].

        raises  NoConvergence where the polynomials have no such point, as at heights far outside their range
        """
        geographic = self.ground_where_any(xy_px, height)
        lost = np.flatnonzero(np.isnan(geographic[:, 0]))
        if len(lost):
            k = int(lost[0])
            x, y = np.atleast_2d(xy_px)[k]
            raise NoConvergence(
                "rpc.no_ground_point",
                image_line=y - 0.5,
                sample=x - 0.5,
                height_m=geographic[k, 2],
                others=len(lost) - 1,
                n=len(geographic),
                low_m=self.height_range_m[0],
                high_m=self.height_range_m[1],
            )
        return geographic

    def ground_where_any(self, xy_px: Array, height: Array | float) -> Array:
        """As `localise`, with NaN for longitude and latitude of image points that have no ground point there."""
        xy_px = np.atleast_2d(np.asarray(xy_px, float))
        geographic = np.empty((len(xy_px), 3))
        geographic[:, 2] = height
        H = (geographic[:, 2] - self.ground_offset[2]) / self.ground_scale[2]
        near = np.abs(H) <= max(FAR_RANGES, FAR_M / float(self.ground_scale[2]))
        found = np.full((len(xy_px), 2), np.nan)
        found[near] = ground_points(self._ratios, ((xy_px - self.image_offset) / self.image_scale)[near], H[near])
        geographic[:, :2] = self.ground_offset[:2] + self.ground_scale[:2] * found
        return geographic

    def pixel_on_ground(self) -> Array:
        """(2, 2) metres east and north (columns) of one pixel in x and in y (rows), at the centre of the scene."""
        centre = self.ground_offset[None]
        by_ground = self.project_with_partials(centre)[1][0, :, :2]
        return np.linalg.inv(by_ground / metres_per_geographic(centre)[0, :2]).T

    def bias_sigma_px(self) -> Array | None:
        """(2,) `err_bias_m` in px along x and y; None where the RPC shows none."""
        if not self.err_bias_m:
            return None
        return self.err_bias_m / np.linalg.norm(self.pixel_on_ground(), axis=1)

    def to_rasterio(self) -> Any:
        """The same as `rasterio.rpc.RPC`; raises InputError where rasterio is not installed."""
        return rasterio_from_rpc(self)

    def shifted(self, shift_px: Array) -> Rpc:
        """The RPC with an image shift (2,) in its offsets: exact, and understood by every program."""
        return replace(self, image_offset=self.image_offset + shift_px)

    def spread_over(self, size_px: Array) -> Rpc:
        """The same function with offsets and scales of an image of size (2,): its middle, and half of it.

        x = o + s n / d = o' + s' n' / d with n' = (s n + (o - o') d) / s', exactly.  For an image cut out of a scene,
        whose offsets are not its range.
        """
        offset = scale = np.asarray(size_px, float) / 2
        c = self.coefficients.copy()
        for axis, top in ((0, 2), (1, 0)):
            away = self.image_offset[axis] - offset[axis]
            c[top] = (self.image_scale[axis] * c[top] + away * c[top + 1]) / scale[axis]
        return replace(self, coefficients=c, image_offset=offset, image_scale=scale)

    def middle_in_range(self) -> bool:
        """Whether the middle of the ground's range is seen within the range of the image that offset and scale say.

        So it is in every RPC that was fitted for its image; where not, the offsets belong to something else.
        """
        c = self.coefficients[:, 0]
        return bool(abs(c[0] / c[1]) <= RANGE and abs(c[2] / c[3]) <= RANGE)

    def outside(self, geographic: Array) -> Mask:
        """(n,) whether a point lies outside the range for which the polynomials were fitted."""
        from_centre = _rows(geographic) - self.ground_offset
        from_centre[:, 0] -= 360 * np.round(from_centre[:, 0] / 360)
        beyond: Mask = np.abs(from_centre / self.ground_scale) > RANGE
        return np.logical_or.reduce(beyond, axis=1)

    def heights_outside(self, geographic: Array) -> Mask:
        """(n,) whether the height of a point lies outside those for which the polynomials were fitted."""
        beyond: Mask = np.abs(_rows(geographic)[:, 2] - self.ground_offset[2]) > RANGE * self.ground_scale[2]
        return beyond

    def ranges_away(self, geographic: Array) -> Array:
        """(n,) distance in plan from the middle of the scene, in units of half its range; beyond 5 there is no place.

        The larger of that in longitude and that in latitude.
        """
        from_centre = _rows(geographic) - self.ground_offset
        from_centre[:, 0] -= 360 * np.round(from_centre[:, 0] / 360)
        return np.abs(from_centre / self.ground_scale)[:, :2].max(axis=1, initial=0.0)

    def check_near(self, geographic: Array, names: Sequence[str]) -> None:
        """Raise InputError where points (n, 3) lie so far from the scene that the RPC states nothing of them."""
        far = self.ranges_away(geographic)
        lost = np.flatnonzero(~(far < NO_PLACE))
        if not len(lost):
            return
        turned = np.abs((geographic[:, [1, 0]] - self.ground_offset[:2]) / self.ground_scale[:2]).max(axis=1)
        swapped = bool((turned[lost] < NO_PLACE).all())
        k = int(lost[0])
        lon, lat, _ = geographic[k]
        centre = self.ground_offset
        raise InputError(
            "rpc.points_far_away",
            n=len(lost),
            total=len(far),
            point=names[k],
            longitude_deg=lon,
            latitude_deg=lat,
            ratio=far[k],
            centre_longitude_deg=centre[0],
            centre_latitude_deg=centre[1],
            limit=NO_PLACE,
            exchanged=swapped,
        )

    @property
    def height_range_m(self) -> tuple[float, float]:
        """Lowest and highest height for which the polynomials were fitted."""
        low, high = (self.ground_offset[2] + self.ground_scale[2] * np.array([-1, 1])).tolist()
        return low, high

    def _image(self, u: Array, v: Array) -> Array:
        return self.image_offset + self.image_scale * np.stack([u, v], axis=1)

    def _ratios(self, normalised: Array) -> tuple[Array, Array, Array]:
        """As `Ratios`; infinite or NaN at a pole."""
        n = len(normalised)
        uv, J, least = np.empty((n, 2)), np.empty((n, 2, 2)), np.empty(n)
        c = self.coefficients
        slopes_of = np.concatenate(c @ _DERIVATIVES[:2])  # (8, 10)
        with np.errstate(all="ignore"):
            for start in range(0, n, CHUNK):
                part = slice(start, start + CHUNK)
                T = fill_terms(normalised[part].T, np.empty((20, len(normalised[part]))))
                values, slopes = c @ T, (slopes_of @ T[:10]).reshape(2, 4, -1)
                for axis, top in ((0, 2), (1, 0)):  # x is the sample, y the line
                    ratio = values[top] / values[top + 1]
                    uv[part, axis] = ratio
                    J[part, axis] = ((slopes[:, top] - ratio * slopes[:, top + 1]) / values[top + 1]).T
                least[part] = np.minimum(values[1] / c[1, 0], values[3] / c[3, 0])
        return uv, J, least

    def _evaluated(self, geographic: Array, *, partials: bool) -> Iterator[tuple[slice, tuple[Array, Array]]]:
        """The four polynomials (4, m) and their slopes (3, 4, m) by L, P, H, chunk by chunk."""
        c = self.coefficients
        slopes_of = np.concatenate(c @ _DERIVATIVES)  # (12, 10)
        terms = np.empty((20, CHUNK))
        for start in range(0, len(geographic), CHUNK):
            part = slice(start, min(start + CHUNK, len(geographic)))
            m = part.stop - start
            T = terms[:, :m]
            from_centre = geographic[part] - self.ground_offset
            from_centre[:, 0] -= 360 * np.round(from_centre[:, 0] / 360)  # across 180 degrees
            fill_terms((from_centre / self.ground_scale).T, T)
            values = c @ T
            self._check_denominators(values, geographic, start)
            slopes = (slopes_of @ T[:10]).reshape(3, 4, m) if partials else T
            yield part, (values, slopes)

    def _check_denominators(self, values: Array, geographic: Array, start: int) -> None:
        for row, which in ((1, "line"), (3, "sample")):
            relative = values[row] / self.coefficients[row, 0]
            if (k := int(np.argmin(relative))) >= 0 and not relative[k] > LEAST_DENOMINATOR:
                lon, lat, h = geographic[start + k]
                raise InputError(
                    "rpc.small_denominator",
                    axis=which,
                    ratio=relative[k],
                    limit=LEAST_DENOMINATOR,
                    longitude_deg=lon,
                    latitude_deg=lat,
                    height_m=h,
                    low_m=self.height_range_m[0],
                    high_m=self.height_range_m[1],
                )


def rpc_of(
    *, coefficients: ArrayLike, ground_offset: ArrayLike, ground_scale: ArrayLike, image_offset: ArrayLike,
    image_scale: ArrayLike, err_bias_m: float | None = None, err_rand_m: float | None = None,
) -> Rpc:  # fmt: skip
    """The RPC of a file, whose scales may be negative (Planet's latitudes): the same function with positive ones.

    A negative scale of the ground turns the sign of the terms that are odd in its coordinate, one of the image that
    of its numerator; both exactly.
    """
    c, ground = np.array(coefficients, float), np.array(ground_scale, float)
    image = np.array(image_scale, float)
    if c.shape == (4, 20) and ground.shape == (3,) and image.shape == (2,):
        for axis in np.flatnonzero(ground < 0):
            c *= [(-1.0) ** term.count("LPH"[axis]) for term in TERMS]
        for axis, top in ((0, 2), (1, 0)):
            if image[axis] < 0:
                c[top] *= -1
    return Rpc(
        coefficients=c,
        ground_offset=np.array(ground_offset, float),
        ground_scale=np.abs(ground),
        image_offset=np.array(image_offset, float),
        image_scale=np.abs(image),
        err_bias_m=err_bias_m,
        err_rand_m=err_rand_m,
    )


def observe_rpc(rpc: Rpc, place: LocalPlace, xyz: Array, kind: BiasKind, bias: Array) -> Observed:
    """Image points of an RPC scene with its bias, and all partial derivatives.

    place  where the local frame of the object points stands on the ellipsoid
    xyz    (n, 3) object points, local [m];  bias (k,) [px], in the order of `BIAS_PARAMETERS`
    raises  InputError where a denominator vanishes
    """
    return observe_rpc_at(rpc, Local(origin=place.origin, ellipsoid=place.ellipsoid), xyz, kind, bias)


def observe_rpc_at(rpc: Rpc, place: Place, xyz: Array, kind: BiasKind, bias: Array) -> Observed:
    """As `observe_rpc`, for object points (n, 3) in any frame whose place on the earth is known."""
    geographic = place.geographic_from_block(xyz)
    xy, by_geographic = rpc.project_with_partials(geographic)
    by_point = by_geographic @ place.geographic_by_block(xyz, geographic)
    uv = (xy - rpc.image_offset) / rpc.image_scale
    design = bias_design(kind, uv)
    by_image = np.eye(2) + bias_slope(kind, bias) / rpc.image_scale
    return Observed(xy_px=xy + design @ np.asarray(bias, float), by_point=by_image @ by_point, by_parameters=design)


def correct_image(rpc: Rpc, xy_px: Array, kind: BiasKind, bias: Array) -> Array:
    """Image points (n, 2) of the RPC that belong to measured ones (n, 2): the bias taken off again.

    For rays and localisation: rpc.localise(correct_image(...), height).
    """
    slope = np.eye(2) + bias_slope(kind, bias) / rpc.image_scale
    constant = bias_design(kind, np.zeros((1, 2)))[0] @ np.asarray(bias, float)
    return rpc.image_offset + np.linalg.solve(slope, (xy_px - rpc.image_offset - constant).T).T


def fill_terms(normalised: Array, out: Array) -> Array:
    """The 20 terms (20, n) of normalised longitude, latitude, height (3, n), written to `out` and returned."""
    T = out
    T[0], T[1:4] = 1.0, normalised
    L, P, H = T[1:4]
    np.multiply(L, P, out=T[4])
    np.multiply(T[1:3], H, out=T[5:7])
    np.multiply(T[1:4], T[1:4], out=T[7:10])
    np.multiply(T[4], H, out=T[10])
    np.multiply(L, T[7:10], out=T[11:14])
    np.multiply(P, T[7:10], out=T[14:17])
    np.multiply(H, T[7:10], out=T[17:20])
    return T


def _rows(geographic: Array) -> Array:
    rows = np.asarray(geographic, float)
    if rows.ndim != 2 or rows.shape[1] != 3:
        raise InputError("rpc.point_shape", shape=rows.shape)
    return rows


def rasterio_from_rpc(rpc: Rpc) -> Any:
    """A `rasterio.rpc.RPC`, which `dataset.rpcs = ...` and `rasterio.warp.reproject(rpcs=...)` take.

    raises  InputError where rasterio is not installed
    """
    try:
        kind: Any = import_module("rasterio.rpc").RPC  # an extra
    except ImportError:
        raise InputError("package.rasterio_missing") from None
    x, y = (rpc.image_offset - 0.5).tolist()
    lon, lat, height = rpc.ground_offset.tolist()
    lon_scale, lat_scale, height_scale = rpc.ground_scale.tolist()
    return kind(
        height_off=height, height_scale=height_scale, lat_off=lat, lat_scale=lat_scale, long_off=lon,
        long_scale=lon_scale, line_off=y, line_scale=float(rpc.image_scale[1]), samp_off=x,
        samp_scale=float(rpc.image_scale[0]), err_bias=rpc.err_bias_m, err_rand=rpc.err_rand_m,
        **{name: c.tolist() for name, c in zip(POLYNOMIALS, rpc.coefficients, strict=True)},
    )  # fmt: skip
