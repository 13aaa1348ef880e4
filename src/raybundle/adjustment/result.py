"""What an adjustment returns: plain data, read by reports and written to result folders.

Standard deviations and covariances carry the a-posteriori sigma0; test values w and smallest
detectable blunders carry the a-priori one, as BLOCK_FORMAT states.  Arrays are parallel to the
tables of the block.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from html import escape
from typing import TYPE_CHECKING

import numpy as np

from raybundle.adjustment.records.arrays import Interior, Interiors, ObjectPoints, Poses
from raybundle.adjustment.records.figures import (
    GroupFactor,
    InteriorResult,
    NetworkFigures,
    ObservationGroup,
    ObservationStatistics,
    ParameterResult,
    Precision,
    VarianceComponent,
    printed_unit,
)
from raybundle.adjustment.records.notice import Notice, sorted_notices
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.records.severity import Severity
from raybundle.adjustment.statistics.covariances import covariance_of
from raybundle.adjustment.statistics.fields import WHITE, Noise
from raybundle.adjustment.statistics.system_state import Work
from raybundle.block import Block, Camera, Role
from raybundle.block.rigs import without_rigs
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array
from raybundle.numerics.counting import counted, grouped

if TYPE_CHECKING:
    from raybundle.cameras.opencv import OpenCVCamera

COLOURS = {Severity.FAULT: "#a12f2f", Severity.WARNING: "#b5532a", Severity.NOTE: "#5b6774"}
NOTICES = 5
"""Notices that a notebook shows."""


class Handle:
    """The factored normal equations behind a result, for `raybundle.adjustment.evaluation.queries`.

    A result is plain data and can be copied, kept and sent to another process; its handle stays behind: the copy has an
    empty one, and an error asks for a new adjustment.
    """

    __slots__ = ("work",)

    def __init__(self, work: Work | None = None) -> None:
        """An empty handle, or one of an adjusted system."""
        self.work = work

    def __reduce__(self) -> tuple[type[Handle], tuple[()]]:
        """Of copies: an empty one."""
        return Handle, ()

    def __repr__(self) -> str:
        """Whether it can answer."""
        return "<Handle, empty>" if self.work is None else "<Handle>"


EMPTY = Handle()


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Adjustment:
    """The result of an adjustment."""

    given: Block
    """The block as it was given."""
    adjusted: Block
    """The same with adjusted interior and exterior orientations and object points."""
    options: AdjustmentOptions
    sigma0: float
    """A posteriori, times 1 a priori: sqrt(sum (v/s)^2 / redundancy); NaN without redundancy."""
    weighted_square_sum: float
    redundancy: int
    observations: int
    unknowns: int
    constraints: int
    datum: str
    """In words: "inner constraints over all object points (position, rotation, scale)"."""
    datum_defect: tuple[str, ...]
    """Parts of the datum that the observations leave open: "position X", "rotation Z", "scale" ..."""
    converged: bool
    iterations: int
    seconds: float
    global_test: tuple[float, float, float]
    """Lower limit, sum of squares, upper limit of the two-sided chi-square test at 5 %."""
    image_observations: ObservationStatistics
    groups: tuple[ObservationGroup, ...]
    precision: Precision | None
    """None where `options.statistics` is off."""
    interior: tuple[InteriorResult, ...]
    variance_components: tuple[VarianceComponent, ...]
    network: NetworkFigures | None
    not_determinable: tuple[str, ...]
    not_significant: tuple[str, ...]
    critical_w: float
    """Family-wise critical value of w."""
    critical_tau: float
    """Family-wise critical value of t = tau (Pope 1976)."""
    suspects: tuple[tuple[str, str, float, float], ...]
    """Image, point, largest |w|, largest correlation with another suspect's w."""
    notices: tuple[Notice, ...]
    condition: float
    """Condition number of the scaled reduced normal matrix (estimate)."""
    group_factors: tuple[GroupFactor, ...] = ()
    """With `options.variance_groups`: what given standard deviations were multiplied by; `given` has the product."""
    p_wrong: Array | None = None
    """(n,) probability that the station of each image is wrong (`raybundle.ties.wrong_stations`), NaN where it is not
    judged; None: nothing shows it."""
    noise: Noise = WHITE
    """What standard deviations rest on; tests and smallest detectable blunders rest on white noise in any case."""
    handle: Handle = field(default=EMPTY, compare=False)
    """For `raybundle.adjustment.evaluation.queries`; empty without statistics, and in copies"""

    @property
    def length_unit(self) -> str:
        """Unit of lengths in object space; empty where nothing fixes the scale."""
        return "" if self.free_scale else self.given.length_unit

    @property
    def free_scale(self) -> bool:
        """Whether nothing fixes the scale, neither observations nor a nominal length."""
        return "scale" in self.datum_defect and not self.given.nominal_scale

    @property
    def variance_factor(self) -> float:
        """What covariances are cofactors times: sigma0^2, or 1 without redundancy and with factors of groups."""
        return variance_factor(self.options, self.sigma0, self.redundancy)

    def opencv(
        self, camera: str | None = None, *, image: str | None = None, coefficients: int | None = None
    ) -> OpenCVCamera:
        """A calibrated camera as OpenCV has it: K, distortion, and the covariance of both.

        camera        its id; None: the only one
        image         where each image has an interior orientation of its own
        coefficients  4, 5, 8, 12 or 14; None: the fewest that are exact, or within 0.01 px
        raises        InputError for an unknown camera, and where OpenCV has none within 0.1 px (`opencv_camera`)
        """
        from raybundle.cameras.opencv import opencv_camera

        return opencv_camera(*interior_of(self, camera, image), coefficients=coefficients)

    def poses(self) -> Poses:
        """Projection centres, rotations and 4 x 4 matrices of all images, with covariances (n, 6, 6)."""
        block, known = self.adjusted, self.precision
        images = block.images
        seen = np.isin(np.arange(len(images)), block.observations.image[self.image_observations.used])
        scene = np.array([c.is_scene for c in block.cameras], bool)[images.camera]
        lost = np.where(seen & ~scene, 0.0, np.nan)
        return Poses(
            ids=images.ids, centre=images.centre + lost[:, None], rotation=images.rotation + lost[:, None, None],
            covariance=None if known is None else known.images + lost[:, None, None],
            alone=without_rigs(block).images, length_unit=self.length_unit,
        )  # fmt: skip

    def points(self) -> ObjectPoints:
        """Coordinates of all object points, with covariances (p, 3, 3)."""
        points, known = self.adjusted.points, self.precision
        return ObjectPoints(
            ids=points.ids, role=tuple(Role(r).word for r in points.role.tolist()), xyz=points.xyz,
            covariance=None if known is None else known.object_points, length_unit=self.length_unit,
        )  # fmt: skip

    def cameras(self) -> Interiors:
        """Interior orientations, with covariances (k, k) of their parameters."""
        return Interiors(tuple(_interior(self, i) for i in self.interior))

    def covariance(self, first: str, second: str | None = None) -> Array:
        """Covariance (k, l) between any two objects, or (k, k) of one.

        first, second  "point:7", "image:DSC01", "camera:1"; components X, Y, Z; X, Y, Z, omega, phi, kappa [rad]; the
                       free parameters in their order
        raises         InputError for names that took no part, and of a copy of a result, which cannot answer
        """
        if self.handle.work is None:
            raise InputError("adjustment.no_statistics")
        found = self.variance_factor * covariance_of(self.handle.work, first, second or first)
        rough = None if self.precision is None else self.precision.roughness
        kind, _, name = first.partition(":")
        if second not in {None, first} or kind != "point" or rough is None:
            return found
        relief = rough[self.given.points.ids.index(name)]
        return found + np.outer(relief, relief)

    def __repr__(self) -> str:
        """One line."""
        return line_of(self)

    def _repr_html_(self) -> str:
        """For notebooks: what was adjusted, interior orientations, the gravest notices."""
        return html_of(self)


def variance_factor(options: AdjustmentOptions, sigma0: float, redundancy: int) -> float:
    """What covariances are cofactors times.

    sigma0^2, one factor for all observations; 1 where nothing shows it, and where each group of observations has a
    factor of its own, which its standard deviations contain.
    """
    return sigma0**2 if redundancy > 0 and not options.variance_groups else 1.0


def interior_of(
    result: Adjustment, camera: str | None, image: str | None
) -> tuple[Camera, tuple[str, ...], Array | None]:
    """A camera with its adjusted values, the symbols that were estimated, and their covariance (u, u).

    camera  its id; None: the only one; image: where parameters differ from image to image
    None in place of the covariance: without statistics.
    raises  InputError for an unknown camera or image, where one of several has to be named, and of a copy of a result
            whose parameters are partly an image's own, partly shared: their covariance cannot be asked of it
    """
    cameras = [c for c in result.adjusted.cameras if not c.is_scene]
    if camera is None:
        if len(cameras) != 1:
            raise InputError("camera.several", n=len(cameras), cameras=[c.id for c in cameras])
        camera = cameras[0].id
    found = next((c for c in cameras if c.id == camera), None)
    if found is None:
        raise InputError("camera.unknown", camera=camera, known=[c.id for c in cameras])
    motion = {p.symbol for p in found.sensor.parameters if p.kind in {"read-out", "other"}}
    every = [
        i for i in result.interior if i.camera == camera and (i.image is None or not motion.issuperset(i.parameters))
    ]
    parts = [i for i in every if i.image is None or i.image == image]
    if image is not None and all(i.image is None for i in parts):
        raise InputError("camera.no_interior_of_image", camera=camera, image=image)
    if image is None and any(i.image is not None for i in every):
        raise InputError("camera.interior_per_image", camera=camera)
    found = replace(found, values={**found.values, **{s: p.value for i in parts for s, p in i.parameters.items()}})
    if result.precision is None:
        return found, (), None
    parts = [i for i in parts if i.free]
    keys = [i.camera if i.image is None else f"{i.camera}/{i.image}" for i in parts]
    known = [result.precision.interior[key] for key in keys]
    if len(keys) < 2:
        return found, parts[0].free if parts else (), known[0] if known else np.zeros((0, 0))
    between = result.covariance(*(f"camera:{key}" for key in keys))
    C = np.block([[known[0], between], [between.T, known[1]]])
    return found, tuple(s for i in parts for s in i.free), C


def _interior(a: Adjustment, i: InteriorResult) -> Interior:
    """An interior orientation with the covariance of all its parameters, those that are held included."""
    symbols, covariance = tuple(i.parameters), None
    if a.precision is not None:
        free = [symbols.index(s) for s in i.free]
        covariance = np.zeros((len(symbols), len(symbols)))
        key = i.camera if i.image is None else f"{i.camera}/{i.image}"
        covariance[np.ix_(free, free)] = a.precision.interior.get(key, np.zeros((len(free), len(free))))
    parameters = i.parameters.values()
    return Interior(
        camera=i.camera, image=i.image, symbols=symbols, units=tuple(p.unit for p in parameters),
        values=np.array([p.value for p in parameters]), covariance=covariance,
    )  # fmt: skip


def line_of(a: Adjustment) -> str:
    """One line: what was adjusted, how well it fits, in which datum, and how many notices there are."""
    used = a.image_observations.used
    parts = [
        repr(a.given.name),
        counted(len(set(a.given.observations.image[used].tolist())), "image"),
        counted(len(set(a.given.observations.point[used].tolist())), "object point"),
        f"sigma0 {a.sigma0:.4g}" if math.isfinite(a.sigma0) else "no sigma0",
        f"redundancy {grouped(a.redundancy)}",
        *([] if a.converged else ["not converged"]),
        *(counted(n, s.value) for s in Severity if (n := sum(x.severity is s for x in a.notices))),
    ]
    return f"<Adjustment {', '.join(parts)}>"


def html_of(a: Adjustment) -> str:
    """A small table: the line above, interior orientations, the gravest notices."""
    head = f"<p><b>{escape(line_of(a)[1:-1])}</b><br>datum: {escape(a.datum)}</p>"
    rows = "".join(
        f"<tr><td>{escape(i.camera if i.image is None else f'{i.camera}, {i.image}')}</td><td>{escape(p.symbol)}</td>"
        f"<td>{p.value:.6g}</td><td>{_std(p)}</td><td>{escape(printed_unit(p.unit, a.length_unit))}</td>"
        f"<td>{escape(p.status)}</td></tr>"
        for i in a.interior
        if i.image is None
        for p in i.parameters.values()
        if p.std is not None or p.value
    )
    titles = "".join(f"<th>{t}</th>" for t in ("camera", "parameter", "value", "sigma", "unit", ""))
    table = f"<table><tr>{titles}</tr>{rows}</table>" if rows else ""
    reported = sorted_notices(a.notices)
    notices = "".join(
        f'<li><b style="color:{COLOURS[n.severity]}">{n.severity.value}</b>: {escape(n.text)}</li>'
        for n in reported[:NOTICES]
    )
    more = f"<li>and {counted(len(reported) - NOTICES, 'more notice')}</li>" if len(reported) > NOTICES else ""
    return f"<div>{head}{table}{f'<ul>{notices}{more}</ul>' if notices else ''}</div>"


def _std(p: ParameterResult) -> str:
    return "" if p.std is None else f"{p.std:.2g}"
