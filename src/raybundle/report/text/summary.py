"""A result in a few messages, as commands print it."""

from __future__ import annotations

import math

import numpy as np

from raybundle.adjustment.evaluation.check_points import check_differences
from raybundle.adjustment.evaluation.counts import counts
from raybundle.adjustment.evaluation.tie_roughness import doubled
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.statistics.far_points_share import few_hold
from raybundle.adjustment.statistics.fields import Noise
from raybundle.adjustment.statistics.network import classed
from raybundle.block import Block
from raybundle.errors import Message, note
from raybundle.io.photos.start import NOMINAL_PIXEL_MM
from raybundle.numerics.arrays import Array
from raybundle.report.view import length_unit, printed_lengths


def adjusted(a: Adjustment) -> Message:
    """How much was adjusted."""
    n = counts(a)
    return note(
        "summary.adjusted", images=n.images_used, points=n.points_used, observations=n.image_observations_used,
        rejected=n.rejected,
    )  # fmt: skip


def accuracy(a: Adjustment) -> Message:
    """How good it is, in one number: at check points where there are any, else the precision of object points."""
    check, difference = check_differences(a)
    factor, unit = printed_lengths(a)
    if np.isfinite(difference).any():
        rms = factor * float(np.sqrt(np.nanmean(difference**2)))
        return note("summary.accuracy_of_check_points", rms=rms, unit=unit, n=len(check))
    std = _free_std(a)
    if a.precision is None:
        return note("summary.no_statistics")
    if std is None:
        return note("summary.no_object_points")
    rms = factor * float(np.sqrt((std**2).mean()))
    few = few_hold(std)
    median = rms if few is None else factor * few.coordinate  # as page 1 of the report
    return note("summary.precision", rms=rms, median=median, few=few is not None, unit=unit, free_scale=a.free_scale)


def details(a: Adjustment) -> list[Message]:
    """Counts, sigma0, datum, precision, noise and check points."""
    return [
        _counts(a), _sigma0(a), note("summary.datum", datum=a.datum), *_precision(a), *noise_messages(a.noise),
        *_relief(a), *_check_points(a),
    ]  # fmt: skip


def _counts(a: Adjustment) -> Message:
    n = counts(a)
    return note(
        "summary.counts", images=n.images_used, images_given=n.images_given, points=n.points_used,
        points_given=n.points_given, observations=n.image_observations_used,
        observations_given=n.image_observations_given, rejected=n.rejected,
    )  # fmt: skip


def _sigma0(a: Adjustment) -> Message:
    px, um, one = a_priori(a.given)
    return note(
        "summary.sigma0", known=math.isfinite(a.sigma0), sigma0=a.sigma0 if math.isfinite(a.sigma0) else 0.0,
        sigma_px=px, sized=um is not None, sigma_um=um or 0.0, one=one, redundancy=a.redundancy,
    )  # fmt: skip


def a_priori(block: Block) -> tuple[float, float | None, bool]:
    """The standard deviation of an image coordinate as given [px], the same [um], and whether all are the same.

    The median where they differ; None where those of no camera have a size: of scenes, and of photographs that do not
    state it.
    """
    std = np.sqrt(block.observations.cov_px2[:, :2])
    pixel = np.array([c.pixel_mm for c in block.cameras])[block.images.camera[block.observations.image]]
    px, um = float(np.median(std)), float(np.median(std * pixel * 1000))
    nominal = (NOMINAL_PIXEL_MM, NOMINAL_PIXEL_MM)
    sized = any(not c.is_scene and tuple(c.pixel_mm) != nominal for c in block.cameras)
    return px, um if sized else None, bool(np.ptp(std) <= 1e-3 * px)


def _free_std(a: Adjustment) -> Array | None:
    """Standard deviations (n, 3) of object points that are not held; None without any."""
    if a.precision is None:
        return None
    std: Array = a.precision.object_point_std
    free = np.isfinite(std).all(axis=1) & (std > 0).any(axis=1)
    return std[free] if free.any() else None


def _precision(a: Adjustment) -> list[Message]:
    std = _free_std(a)
    if std is None:
        return [accuracy(a)] if a.precision is None else []
    factor, unit = printed_lengths(a)
    x, y, z = (np.sqrt((std**2).mean(axis=0)) * factor).tolist()
    found = [note("summary.precision_of_axes", x=x, y=y, z=z, unit=unit, free_scale=a.free_scale)]
    if (few := few_hold(std)) is not None:
        x, y, z = (factor * few.median).tolist()
        found.append(note("summary.few_points", n=few.points, of=few.of, share=few.share, x=x, y=y, z=z, unit=unit))
    network = a.network
    if network is not None and math.isfinite(network.relative_precision):
        found.append(note(
            "summary.relative_precision", n=round(float(f"{network.relative_precision:.2g}")),
            std=network.mean_std * factor, std_unit=unit, extent=network.extent, extent_unit=length_unit(a),
            omitted=1 - network.mean_share, class_name=network.precision_class if classed(a.given) else "none",
        ))  # fmt: skip
    return found


def noise_messages(noise: Noise) -> list[Message]:
    """What standard deviations rest on, where it is not white noise or was to be something else."""
    if noise.kind == "white":
        return [note("summary.noise_white", cause=noise.reason)] if noise.reason else []
    found = [note("summary.noise_neighbours", factor=noise.phi)]
    if noise.tau_px > 0:
        found.append(note("summary.noise_smooth", sigma_px=noise.tau_px))
    if noise.focus_px > 0:
        found.append(note("summary.noise_focus", sigma_px=noise.focus_px))
    ratios = (
        ("interior", noise.ratio_interior), ("centres", noise.ratio_images), ("points", noise.ratio_points)
    )  # fmt: skip
    return [*found, *(note("summary.noise_factor", kind=k, factor=r) for k, r in ratios if math.isfinite(r))]


def _relief(a: Adjustment) -> list[Message]:
    """For how many tie points relief within the window counts most."""
    wide, of = doubled(a.precision)
    return [note("summary.relief", share=wide / of)] if of else []


def _check_points(a: Adjustment) -> list[Message]:
    check, difference = check_differences(a)
    known = np.asarray(np.isfinite(difference).any(axis=0))
    if not known.any():
        return []
    factor, unit = printed_lengths(a)
    rms = factor * np.sqrt(np.nanmean(difference[:, known] ** 2, axis=0))
    axes = [axis for axis, there in zip("XYZ", known.tolist(), strict=True) if there]
    return [note("summary.check_points", axes=axes, rms=rms.tolist(), n=len(check), unit=unit)]
