"""What a piece of work takes on a machine: constants with their units, as they were measured."""

from __future__ import annotations

import os
import platform
from dataclasses import dataclass
from importlib.resources import files
from pathlib import Path

import msgspec

from raybundle.io.user_folders import made_again_folder

REVISION = 4
"""Raised with every change of what is measured; constants of another are measured again"""
SWEEPS = ("up", "down", "covariances", "statistics")
"""Kinds of tasks of an adjustment in parts, as they are distinguished here"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Sweep:
    """What a task of one sweep takes; measured by its tasks in an adjustment of a made flight."""

    task_s: float
    """CPU seconds of a task that has nothing to do"""
    point_us: float
    """CPU microseconds for an image point that the part reduces"""
    element_ns: float
    """CPU nanoseconds for an element of the front, (own + boundary)^2 of them"""
    operation_ns: float
    """CPU nanoseconds for a thousand floating-point operations on the front"""
    read_point: float
    """bytes read for an image point"""
    read_element: float
    """bytes read for an element"""
    written_point: float
    """bytes written for an image point"""
    written_element: float
    """bytes written for an element"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Constants:
    """What work takes on a processor, as measured by `measure`, or as shipped."""

    processor: str
    version: str
    """of raybundle"""
    revision: int
    measured: str
    """day, and what of it was measured there"""

    # the adjustment
    up: Sweep
    down: Sweep
    covariances: Sweep
    statistics: Sweep
    cutting_point_us: float
    """CPU microseconds of the driver for an image point and each doubling of their number: read, hashed, sorted, cut,
    written to its part"""
    driver_task_ms: float
    """CPU milliseconds of the driver for a task that it hands out and whose numbers it adds up"""
    driver_point: float
    """bytes of the driver's memory for an image point"""
    part_point: float
    """bytes of a process's memory for an image point of a part that it holds ready"""
    base_mb: float
    """memory of a process before it has anything to do"""
    stored_point: float
    """bytes on disk for an image point when an adjustment ends: parts, values, statistics"""

    # photographs to approximate values
    feature_mpx_s: float
    """CPU seconds to find and describe the features of a megapixel"""
    nearest_s: float
    """CPU seconds to match a pair of 1000 features each; grows with the square of their number"""
    verify_ms: float
    """CPU milliseconds to verify a pair, for a thousand features"""
    signature_s: float
    """CPU seconds for the signature of a photograph"""
    likeness_ns: float
    """CPU nanoseconds for a thousand floating-point operations of the likeness of signatures, in float32"""
    compare_ms: float
    """CPU milliseconds to compare a pair by 1000 features"""
    start_point_ms: float
    """CPU milliseconds of tracks and approximate values for an image point"""
    start_image_ms: float
    """CPU milliseconds of tracks and approximate values for each of 2000 photographs"""
    decisions_point_ms: float
    """CPU milliseconds of decisions about weights, blunders and parameters for an image point"""
    decisions_image_ms: float
    """CPU milliseconds of these decisions for each of 2000 photographs"""
    start_shared: float
    """of the CPU seconds of a start in parts those of its leaves, which are tasks"""
    precision_point_ms: float
    """CPU milliseconds of least-squares matching for an image point"""
    precision_shared: float
    """of the CPU seconds of least-squares matching those of its windows, which are tasks"""
    report_point_ms: float
    """CPU milliseconds of results and report for an image point"""
    report_image_ms: float
    """CPU milliseconds of results and report for a photograph"""
    start_point: float
    """bytes of memory for an image point while approximate values are found"""
    start_image: float
    """bytes of memory for a photograph while approximate values are found"""
    decisions_point: float
    """bytes of memory for an image point of a block that is adjusted in one piece, with its decisions"""
    decisions_image: float
    """bytes of memory for a photograph of such a block"""
    precision_point: float
    """bytes of memory for an image point during least-squares matching"""
    report_point: float
    """bytes of memory for an image point while results are written"""
    result_point: float
    """bytes of a result folder for an image point"""


def processor() -> str:
    """What this machine's processor calls itself; with family and model, as virtual machines give many one name."""
    info, model = Path("/proc/cpuinfo"), dict[str, str]()
    if info.exists():
        for line in info.read_text(encoding="utf-8", errors="replace").splitlines():
            name, _, value = line.partition(":")
            model.setdefault(name.strip(), value.strip())
    if "model name" in model:
        more = [f"{name} {model[at]}" for name, at in (("family", "cpu family"), ("model", "model")) if at in model]
        return ", ".join([model["model name"], *more])
    return platform.processor() or platform.machine()


def version() -> str:
    """Of raybundle."""
    from importlib.metadata import version as of

    return of("raybundle")


def shipped() -> Constants:
    """Those that come with the package; their processor is named in them."""
    text = files("raybundle.workflows.costs").joinpath("constants.json").read_bytes()
    return msgspec.json.decode(text, type=Constants)


def cache_file() -> Path:
    """Where the constants of this machine are kept: RAYBUNDLE_CACHE, or the system's place for what is made again."""
    return made_again_folder() / "cost.json"


def kept() -> Constants | None:
    """Those of this machine; None where there are none of this version and processor, or they cannot be read."""
    try:
        found = msgspec.json.decode(cache_file().read_bytes(), type=Constants)
    except (OSError, msgspec.DecodeError):
        return None
    mine = found.processor == processor() and found.version == version() and found.revision == REVISION
    return found if mine else None


def keep(constants: Constants) -> bool:
    """Keep the constants of this machine; False where its place cannot be written: they are measured again then."""
    path = cache_file()
    temporary = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        temporary.write_bytes(msgspec.json.format(msgspec.json.encode(constants), indent=1))
        temporary.replace(path)
    except OSError:
        return False
    return True
