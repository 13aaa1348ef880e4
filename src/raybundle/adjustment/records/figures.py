"""Statistics of an adjustment, as plain data; arrays are parallel to the tables of the block."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from raybundle.block.rejection import Rejections
from raybundle.errors import worded
from raybundle.numerics.arrays import Array, Index, Mask


@dataclass(frozen=True, slots=True, kw_only=True)
class ObservationStatistics:
    """Image observations, pixel frame, y down; one row per row of `Block.observations`."""

    residuals_px: Array
    """(m, 2) adjusted - observed."""
    redundancy: Array
    """(m, 2) redundancy numbers r of x and y; NaN where rejected or without statistics."""
    w: Array
    """(m, 2) normalised residuals v / (s sqrt r), a-priori sigma, signed; NaN where r < 1e-9."""
    t: Array
    """(m, 2) w / sigma0."""
    mdb_px: Array
    """(m, 2) smallest detectable blunder, alpha 0.001, power 0.80; NaN where r < 1e-9."""
    external: Array
    """(m, 2) largest effect of that blunder on its object point's coordinates, length unit of the block."""
    least_control: Array
    """(m,) smaller eigenvalue of the point's 2 x 2 block of Qvv P, 0 .. 1; the larger one is rx + ry less this.

    Where x and y of an observation are correlated, its redundancy numbers may lie outside 0 .. 1, but not these.
    """
    rejected: Rejections
    """(m,) None, or the reason; the adjustment took no notice of a rejected row."""

    used: Mask = field(init=False, repr=False)
    """(m,) rows that took part."""

    def __post_init__(self) -> None:
        """Find the rows that took part, once."""
        import numpy as np

        used = np.ones(len(self.rejected), bool)
        if self.rejected.count(None) < len(used):
            used[:] = [r is None for r in self.rejected]
        used.flags.writeable = False
        object.__setattr__(self, "used", used)


@dataclass(frozen=True, slots=True, kw_only=True)
class ObservationGroup:
    """Residuals and tests of observations outside the images."""

    kind: str
    """control | distance | station | attitude [rad] | parameter | relation (of parameters)"""
    ids: tuple[str, ...]
    """(k,) point id, "from-to", image id, "camera:symbol"."""
    component: tuple[str, ...]
    """(k,) "X", "Y", "Z", "length", "omega", "phi", "kappa", the parameter's symbol or the relation's name."""
    origin: tuple[str, ...] = ()
    """(k,) of relations, where each comes from (`Relation.origin`); () of other kinds."""
    item: Index
    """(k,) row of the kind's table, of control the object point"""
    quantity: Index
    """(k,) which quantity of that row"""
    given: Array
    sigma: Array
    """(k,) a priori; 0 = held."""
    adjusted: Array
    adjusted_std: Array
    residual: Array
    redundancy: Array
    w: Array
    t: Array
    mdb: Array
    square: Array
    """(k,) part of the weighted square sum: (v / sigma)^2, of correlated ones v (P v), which may be negative"""

    def rows(self, keep: Mask | Index) -> ObservationGroup:
        """These of its observations: a mask (k,) or positions."""
        import numpy as np

        chosen = np.flatnonzero(keep) if np.asarray(keep).dtype == bool else keep
        return ObservationGroup(
            kind=self.kind, ids=tuple(self.ids[k] for k in chosen), component=tuple(self.component[k] for k in chosen),
            origin=tuple(self.origin[k] for k in chosen) if self.origin else (),
            item=self.item[chosen], quantity=self.quantity[chosen],
            given=self.given[chosen], sigma=self.sigma[chosen], adjusted=self.adjusted[chosen],
            adjusted_std=self.adjusted_std[chosen], residual=self.residual[chosen], redundancy=self.redundancy[chosen],
            w=self.w[chosen], t=self.t[chosen], mdb=self.mdb[chosen], square=self.square[chosen],
        )  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class Precision:
    """Covariances of the unknowns in the result's datum, a-posteriori sigma0."""

    object_points: Array
    """(p, 3, 3); zero for held coordinates, NaN for points that took no part."""
    images: Array
    """(n, 6, 6) of X, Y, Z, omega, phi, kappa [length unit, rad]."""
    interior: Mapping[str, Array]
    """Camera id (or "camera/image" where each image has its own) -> (k, k), in the order of `parameters`."""
    parameters: Mapping[str, tuple[str, ...]]
    """The same keys -> symbols of the free parameters."""
    interior_exterior: Mapping[str, Array]
    """The same keys -> (images of the camera, k, 6) correlations between interior and exterior orientation."""
    roughness: Array | None = None
    """(p, 3) what relief within the windows of tie points and noise of their places add, which `object_points` holds:
    a vector along the mean ray, as long as its standard deviation; None where no window is known."""

    @property
    def object_point_std(self) -> Array:
        """(p, 3) standard deviations of the object coordinates; NaN where rounding leaves no variance."""
        import numpy as np

        variance = np.diagonal(self.object_points, axis1=1, axis2=2)
        return np.sqrt(np.where(variance >= 0, variance, np.nan))

    @property
    def image_std(self) -> Array:
        """(n, 6) standard deviations of X, Y, Z, omega, phi, kappa."""
        import numpy as np

        return np.sqrt(np.diagonal(self.images, axis1=1, axis2=2))


@dataclass(frozen=True, slots=True, kw_only=True)
class ParameterResult:
    """One parameter of an interior orientation."""

    symbol: str
    unit: str
    meaning: str
    """code of its text, or words"""
    value: float
    std: float | None
    """None where held."""
    t: float | None
    """|value - value without it| / std: significance of an additional parameter; None for c and held ones."""
    determinability: float | None
    """1 / (Q_ii (Q^-1)_ii), 1 = independent of all other unknowns, 0 = not determinable."""
    effect_px: float | None
    """Largest shift over the format that this parameter causes, at its value."""
    effect_std_px: float | None
    """The same for one standard deviation."""
    std_white: float | None = None
    """What `std` would be if the noise of the image coordinates were white; None where that was assumed"""
    status: str
    """held | estimated | observed | not significant | not determinable"""
    remark: str = ""
    values: tuple[tuple[str, str | int | bool], ...] = ()
    """of the text of its meaning, with their names"""

    @property
    def words(self) -> str:
        """Its meaning in words."""
        return worded(self.meaning, **dict(self.values))

    def in_unit(self, words: str, length: str = "") -> str:
        """Words of its value or standard deviation, with the unit."""
        return f"{words} {printed_unit(self.unit, length)}".rstrip()


def printed_unit(unit: str, length: str) -> str:
    """The unit of a parameter in print: "m/s" of "length/s"; of a ratio, and where a length has no unit, none."""
    if unit == "1" or (unit.startswith("length") and not length):
        return ""
    return unit.replace("length", length)


@dataclass(frozen=True, slots=True, kw_only=True)
class InteriorResult:
    """One interior orientation."""

    camera: str
    image: str | None
    """Where each image has its own."""
    parameters: Mapping[str, ParameterResult]
    correlations: Array
    """(k, k) between the free parameters, in the order of `free`."""
    free: tuple[str, ...]
    joint_tests: Mapping[str, tuple[float, float]] = field(default_factory=dict[str, tuple[float, float]])
    """Group of parameters, as "P1 P2" -> F value, probability of a larger one by chance."""


@dataclass(frozen=True, slots=True, kw_only=True)
class VarianceComponent:
    """Ratio of the a-posteriori to the a-priori sigma of a group of observations (Förstner 1979)."""

    kind: str
    """image observations | camera | image | control | distances | stations | attitudes | relations | ..."""
    group: str
    count: int
    redundancy: float
    ratio: float
    """sigma a posteriori / sigma a priori; NaN where the group has no redundancy."""
    significant: bool
    """Whether the ratio differs from that of all other observations together (F test, 1 %, two-sided)."""


@dataclass(frozen=True, slots=True, kw_only=True)
class GroupFactor:
    """By how much the standard deviations of a group of observations were multiplied."""

    kind: str
    """As `VarianceComponent.kind`."""
    group: str
    count: int
    redundancy: float
    factor: float
    """sigma taken / sigma given; 1: as given."""
    estimated: bool
    """Whether the residuals stated it; otherwise the given standard deviation stands."""


@dataclass(frozen=True, slots=True, kw_only=True)
class NetworkFigures:
    """Geometry of the network."""

    rays: Index
    """(p,)"""
    stations_per_point: Index
    """(p,) rays from projection centres that differ by more than a hundredth of the distance."""
    intersection_angle: Array
    """(p,) largest angle between two rays [rad]."""
    base_to_depth: Array
    """(q,) of the image pairs with at least 6 common points."""
    pair_images: Index
    """(q, 2)"""
    pair_points: Index
    """(q,) number of common points."""
    coverage: Array
    """(n,) share of the format covered by the observations (cells of a 10 x 10 grid)."""
    roll: Array
    """(n,) rotation about the viewing axis [rad], against the most frequent one."""
    distance: Array
    """(n,) median distance projection centre - object points."""
    image_scale: Array
    """(n,) image scale number S = distance / c."""
    q: float
    """q of sigma_XYZ = q S sigma_xy / sqrt(k), k = mean rays per point."""
    q_stations: float
    """The same with k = mean stations per point."""
    bound: float
    """The smallest q that this number of rays allows (sqrt(3/2): isotropic directions)."""
    relative_precision: float
    """N of 1:N: `extent` over `mean_std`."""
    extent: float
    """Diagonal of the box of the object points along their principal axes [length unit]; of more than 200 points
    without the 0.25 % at either end of each axis."""
    mean_std: float
    """Mean standard deviation of a free coordinate of the object points [length unit]; NaN without statistics.

    Where a few far points hold half of the variance: without the 5 % that are least precise."""
    mean_share: float = 1.0
    """Share of the points that `mean_std` is of."""
    precision_class: str
    components: int
    """Connected parts of the network."""
