"""What a calibration file is, and how a calibration goes from one program's model to another's."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Literal

import numpy as np

from raybundle.block import Camera
from raybundle.cameras.conversions import (
    CLOSE_PX,
    EXACT,
    LIMIT_PX,
    NOMINAL_SIDE_MM,
    ForwardFit,
    camera_from_forward,
    exact_forward,
    exact_measured,
    forward_fit,
    measured_fit,
)
from raybundle.cameras.forward_camera import TERMS, ForwardCamera, Projection
from raybundle.errors import InputError, phrase
from raybundle.io.calibrations.validity import Validity, validity
from raybundle.io.folders import check_free, make_parent, new_files
from raybundle.io.reading.files import as_utf8, guarded, read_bytes
from raybundle.io.reading.ledger import ledger, not_read
from raybundle.numerics.arrays import Array
from raybundle.sensors import sensor_models

FILE_BYTES = 1 << 26
FITTED = 1e-9
"""A deviation [px] up to which a conversion counts as exact."""
BROWN = ("c", "x0", "y0", "K1", "K2", "K3", "P1", "P2")


@dataclass(frozen=True, slots=True, kw_only=True)
class Calibration:
    """One camera as a file states it: in the direction, and with the parameters, that the file has."""

    id: str
    camera: Camera | ForwardCamera
    """`Camera` where the file corrects the measured point (mm), `ForwardCamera` where it distorts the ideal one."""
    pixel_mm: tuple[float, float] | None = None
    """Size of a pixel; None where the file does not show it."""
    free: tuple[str, ...] = ()
    """Symbols of the parameters whose covariance is known."""
    covariance: Array | None = None
    """(u, u) of `free`; diagonal where the file shows standard deviations alone."""
    remarks: tuple[str, ...] = ()
    """What was assumed or left out."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Variant:
    """One distortion model that a format can hold."""

    name: str
    terms: tuple[str, ...]
    """Out of `forward_camera.TERMS`; without "fy" the two principal distances are the same."""
    projection: Projection = "central"
    fitted: tuple[str, ...] = ()
    """What a fit determines; (): all terms.  Of terms that do nearly the same, one stays zero."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Conversion:
    """A calibration in the model of another program, and how well it stands for what it was made from."""

    calibration: Calibration
    variant: str
    """The distortion model."""
    rms_px: float
    """Root mean square distance between the images of one ray, over a grid on the whole format."""
    largest_px: float
    covered: float
    """Share of the format in which the calibration it was made from has rays."""
    validity: Validity
    """Of the new calibration."""

    @property
    def exact(self) -> bool:
        """Whether nothing was fitted."""
        return self.largest_px <= FITTED


Reader = Callable[[Path, tuple[int, int] | None], tuple[Calibration, ...]]
"""Reads a file; the format in pixels serves where the file does not show it."""
Writer = Callable[[Sequence[Conversion], str], str]
"""The text of the file, by the suffix of its name."""


@dataclass(frozen=True, slots=True, kw_only=True)
class CalibrationFormat:
    """How another program keeps calibrations."""

    name: str
    title: str
    suffixes: tuple[str, ...]
    read: Reader
    write: Writer
    several: bool = False
    """Whether a file holds more than one camera."""
    model: Literal["any", "measured", "photomodeler", "forward"] = "forward"
    """any: our cameras; measured: Brown at the measured point; photomodeler: the same without affinity and shear."""
    variants: tuple[Variant, ...] = ()
    """Of a forward model, the simplest first."""
    recognises: Callable[[str, str], bool]
    """Whether a text, with the suffix of its file, is of this format."""
    keeps: Literal["", "standard deviations", "covariance"] = ""
    """What the format has a place for beside the values."""


calibration_formats: dict[str, CalibrationFormat] = {}


def register(format_: CalibrationFormat) -> CalibrationFormat:
    """Make a format known under its name."""
    calibration_formats[format_.name] = format_
    return format_


def format_named(name: str) -> CalibrationFormat:
    """The format of this name; raises InputError, which lists the known ones."""
    if name not in calibration_formats:
        raise InputError("format.unknown", format=name, known=sorted(calibration_formats))
    return calibration_formats[name]


def recognised(path: Path) -> str:
    """The format of a file by its contents; raises InputError where it cannot be determined."""
    text = _text(path)
    names = [n for n, f in sorted(calibration_formats.items()) if f.recognises(text, path.suffix.lower())]
    if len(names) == 1:
        return names[0]
    known = sorted(calibration_formats)
    if names:
        raise InputError("calibration.format_unclear", names=names, known=known, file=path)
    raise InputError("calibration.format_not_recognised", known=known, file=path)


def _text(path: Path) -> str:
    if path.is_dir():
        raise InputError("file.is_a_folder", file=path)
    return as_utf8(read_bytes(path, FILE_BYTES)).decode("utf-8", "replace")


def read_calibrations(
    path: str | Path, name: str | None = None, *, size_px: tuple[int, int] | None = None
) -> tuple[Calibration, ...]:
    """The calibrations in a file.

    name     of the format; None: recognised by the contents
    size_px  width and height, for files that do not show them; held against those that do
    raises   InputError with file and place for anything that cannot be read
    """
    path = Path(path)
    format_ = format_named(name or recognised(path))
    _text(path)  # a folder, or a file too large for a calibration, is refused before it is parsed
    with guarded(path), ledger() as passed_over:
        found = format_.read(path, size_px)
        remarks = not_read(passed_over.counts())
    for calibration in found:
        size = (calibration.camera.width_px, calibration.camera.height_px)
        if size_px is not None and size != size_px:
            raise InputError(
                "calibration.size_differs",
                camera=calibration.id,
                width_px=size[0],
                height_px=size[1],
                given_width_px=size_px[0],
                given_height_px=size_px[1],
                file=path,
            )
    return (replace(found[0], remarks=(*found[0].remarks, *remarks)), *found[1:]) if found else found


def convert_calibration(
    calibration: Calibration, name: str, *, variant: str | None = None, pixel_mm: float | None = None
) -> Conversion:
    """A calibration in the model of a format: exactly where that can be, else fitted over the whole format.

    variant   name of the distortion model; None: the simplest that is exact, or within 0.01 px, or else the best
    pixel_mm  size of a pixel where neither states it; None: a nominal one, 36 mm over the longer side
    raises    InputError where the format has no such model, or cannot show what the camera sees
    """
    format_ = format_named(name)
    if pixel_mm is not None and not 1e-5 < pixel_mm < 1:
        raise InputError("calibration.pixel_size", pixel_mm=pixel_mm)
    if format_.model == "any" and variant is not None:
        return _to_model(calibration, format_, variant, pixel_mm)
    if format_.model != "forward":
        if variant is not None:
            raise InputError("calibration.one_model", format=name)
        return _to_measured(calibration, format_, pixel_mm)
    choice = [v for v in format_.variants if variant in {None, v.name}]
    if not choice:
        raise InputError(
            "calibration.model_unknown", format=name, model=str(variant), known=[v.name for v in format_.variants]
        )
    return _to_forward(calibration, format_, choice)


def _lost(calibration: Calibration, format_: CalibrationFormat, *, exact: bool) -> tuple[str, ...]:
    """What becomes of the covariance."""
    if calibration.covariance is None:
        return ()
    if not exact:
        return (phrase("calibration_remark.covariance_of_other_model"),)
    if format_.keeps == "covariance":
        return ()
    if format_.keeps == "standard deviations":
        off = calibration.covariance - np.diag(np.diag(calibration.covariance))
        return (phrase("calibration_remark.no_correlations"),) if off.any() else ()
    return (phrase("calibration_remark.no_covariance"),)


def _to_measured(calibration: Calibration, format_: CalibrationFormat, pixel_mm: float | None) -> Conversion:
    camera = calibration.camera
    rms, largest, covered = 0.0, 0.0, 1.0
    needs = {"any": None, "measured": "brown", "photomodeler": "brown"}[format_.model]
    square = format_.model == "photomodeler"
    remarks = calibration.remarks
    if isinstance(camera, Camera) and (needs is None or camera.model == needs) and not (square and _affine(camera)):
        new = camera
    elif isinstance(camera, ForwardCamera) and format_.model == "any":
        size = calibration.pixel_mm[1] if calibration.pixel_mm else pixel_mm
        fit = camera_from_forward(camera, calibration.id, pixel_mm=size)
        new, rms, largest, covered = replace(fit.camera, estimate=()), fit.rms_px, fit.deviation_px, fit.covered
    else:
        blank, free = _blank(calibration, format_, pixel_mm)
        fit = measured_fit(camera, blank, free)
        new, rms, largest, covered = fit.camera, fit.rms_px, fit.deviation_px, fit.covered
    if isinstance(camera, ForwardCamera) and calibration.pixel_mm is None and pixel_mm is None:
        remarks = (*remarks, phrase("calibration_remark.nominal_pixel", side_mm=NOMINAL_SIDE_MM))
    exact = largest <= FITTED and isinstance(camera, Camera)
    kept = replace(calibration, camera=new, pixel_mm=new.pixel_mm) if exact else None
    lost = _lost(calibration, format_, exact=exact)
    return Conversion(
        calibration=replace(
            kept or Calibration(id=calibration.id, camera=new, pixel_mm=new.pixel_mm), remarks=(*remarks, *lost)
        ),
        variant=new.model,
        rms_px=rms,
        largest_px=largest,
        covered=covered,
        validity=validity(new),
    )


def _to_model(calibration: Calibration, format_: CalibrationFormat, model: str, pixel_mm: float | None) -> Conversion:
    """In one of our models that is asked for: term by term where it has the same, else fitted over the format."""
    known = [n for n, m in sensor_models.items() if m.one_exposure and m.scale_symbol == "c" and not m.local_width]
    if model not in known:
        raise InputError("calibration.model_unknown", format=format_.name, model=model, known=sorted(known))
    source = calibration.camera
    if isinstance(source, Camera) and source.model == model:
        return _to_measured(calibration, format_, pixel_mm)
    forward = source if isinstance(source, ForwardCamera) else exact_forward(source)
    blank, _ = _blank(calibration, format_, pixel_mm)
    new = None if forward is None or model not in EXACT else exact_measured(forward, blank, model)
    rms = largest = 0.0
    covered = 1.0
    if new is None:
        symbols = sensor_models[model].symbols
        blank = replace(blank, model=model, values={s: blank.values.get(s, 0.0) for s in symbols})
        fit = measured_fit(source, blank, symbols)
        new, rms, largest, covered = fit.camera, fit.rms_px, fit.deviation_px, fit.covered
    lost = _lost(calibration, format_, exact=False)
    made = Calibration(id=calibration.id, camera=new, pixel_mm=new.pixel_mm, remarks=(*calibration.remarks, *lost))
    return Conversion(
        calibration=made, variant=model, rms_px=rms, largest_px=largest, covered=covered, validity=validity(new)
    )


def _affine(camera: Camera) -> bool:
    return bool(camera.values.get("A") or camera.values.get("S"))


def _blank(
    calibration: Calibration, format_: CalibrationFormat, pixel_mm: float | None
) -> tuple[Camera, tuple[str, ...]]:
    """A Brown camera without distortion to begin with, and what is fitted; without A the pixel takes up affinity."""
    source = calibration.camera
    if isinstance(source, Camera):
        width, height = source.pixel_mm
        values = {s: float(source.values.get(s, 0.0)) for s in ("c", "x0", "y0")}
        stretch = 1.0 + source.values.get("A", source.values.get("C1", 0.0))
    else:
        side = max(source.width_px, source.height_px)
        height = calibration.pixel_mm[1] if calibration.pixel_mm else (pixel_mm or NOMINAL_SIDE_MM / side)
        width, stretch = height, source.fy / source.fx
        middle = np.array([source.cx - source.width_px / 2, source.height_px / 2 - source.cy]) * height
        values = {"c": source.fy * height, "x0": float(middle[0]), "y0": float(middle[1])}
    free = BROWN if format_.model == "photomodeler" else (*BROWN, "A", "S")
    if format_.model == "photomodeler":
        width, values["x0"] = width * stretch, values["x0"] * stretch
    blank = Camera(
        id=calibration.id,
        model="brown",
        width_px=source.width_px,
        height_px=source.height_px,
        pixel_mm=(width, height),
        values={s: values.get(s, 0.0) for s in sensor_models["brown"].symbols},
    )
    return blank, free


def _holds(variant: Variant, camera: ForwardCamera) -> bool:
    """Whether a forward camera has no term that the variant lacks."""
    if variant.projection != camera.projection and camera.vector[4:].any():
        return False
    others = [t for t, v in zip(TERMS, camera.vector.tolist(), strict=True) if v and t not in variant.terms]
    if camera.fx == camera.fy and "fx" in variant.terms:
        others = [t for t in others if t != "fy"]
    return variant.projection == camera.projection and not others


def _to_forward(calibration: Calibration, format_: CalibrationFormat, choice: Sequence[Variant]) -> Conversion:
    camera = calibration.camera
    rms, largest, covered = 0.0, 0.0, 1.0
    exact = None
    same = camera if isinstance(camera, ForwardCamera) else exact_forward(camera)
    if same is not None:
        exact = next((v for v in choice if _holds(v, same)), None)
    if same is not None and exact is not None:
        new, variant = same, exact
    else:
        variant, fit = _best(camera, choice)
        new, rms, largest, covered = fit.camera, fit.rms_px, fit.deviation_px, fit.covered
    pixel = calibration.pixel_mm or (camera.pixel_mm if isinstance(camera, Camera) else None)
    made = Calibration(id=calibration.id, camera=new, pixel_mm=pixel)
    lost = _lost(calibration, format_, exact=exact is not None)
    return Conversion(
        calibration=replace(made, remarks=(*calibration.remarks, *lost)),
        variant=variant.name,
        rms_px=rms,
        largest_px=largest,
        covered=covered,
        validity=validity(new),
    )


def _best(camera: Camera | ForwardCamera, choice: Sequence[Variant]) -> tuple[Variant, ForwardFit]:
    """The first variant within 0.01 px, or the one with the smallest largest deviation."""
    fits: list[tuple[Variant, ForwardFit]] = []
    problem: InputError | None = None
    wide = (camera.projection == "equidistant") if isinstance(camera, ForwardCamera) else camera.sensor.all_round
    for variant in sorted(choice, key=lambda v: (v.projection == "equidistant") != wide):
        try:
            fit = forward_fit(camera, variant.fitted or variant.terms, projection=variant.projection)
        except InputError as error:
            problem = problem or error
            continue
        fits.append((variant, fit))
        if fit.deviation_px <= CLOSE_PX:
            return variant, fit
    if not fits and problem is not None:
        try:
            raise problem
        finally:
            del problem  # it holds this frame, which would hold it
    return min(fits, key=lambda pair: pair[1].deviation_px)


def write_calibrations(
    name: str, conversions: Sequence[Conversion], path: str | Path, *, approximate: bool = False
) -> None:
    """Write calibrations in a format, whole or not at all.

    approximate  also those that deviate from what they stand for by more than 0.1 px
    raises       InputError where something stands at `path`, or a conversion deviates by more
    """
    format_, path = format_named(name), Path(path)
    check_free(path)
    if path.suffix.lower() not in format_.suffixes:
        raise InputError("calibration.suffix", format=name, suffixes=list(format_.suffixes), file=path)
    for c in conversions:
        if not approximate and not c.largest_px <= LIMIT_PX:
            raise InputError(
                "calibration.deviation",
                camera=c.calibration.id,
                model=c.variant,
                deviation_px=c.largest_px,
                rms_px=c.rms_px,
                limit_px=LIMIT_PX,
                file=path,
            )
    if not conversions or (len(conversions) > 1 and not format_.several):
        raise InputError(
            "calibration.one_camera",
            n=len(conversions),
            format=name,
            file=path,
        )
    write_whole(path, format_.write(conversions, path.suffix.lower()))


def write_whole(path: Path, text: str) -> None:
    """Write a text file that is there whole or not at all; raises InputError where that cannot be."""
    make_parent(path)
    with new_files(path) as (file,):
        file.write_text(text, encoding="utf-8", newline="\n")
