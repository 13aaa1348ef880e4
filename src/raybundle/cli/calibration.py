"""`raybundle calibration`: calibrations from and to other programs, compared, and kept in the camera library."""

from __future__ import annotations

import click

from raybundle.cli.calibrations.compare import compare
from raybundle.cli.calibrations.convert import convert
from raybundle.cli.calibrations.library import add, find, list_
from raybundle.cli.calibrations.zoom import zoom
from raybundle.cli.common import Group


@click.group("calibration", cls=Group)
def command() -> None:
    """Calibrations of other programs: convert, compare; the camera library: add, list, find.

    \b
    Formats: opencv, opencv-fisheye, colmap, metashape, kalibr, mrcal, australis, photomodeler, micmac, and
    raybundle, our own TOML file.

    Our model corrects the measured point; most programs distort the ideal one. If the direction changes, the distortion
    is fitted over the whole format, and the remaining deviation is printed.

    \b
    Example:
      raybundle calibration convert camera.yaml --to metashape --out camera.xml
      raybundle calibration compare may.toml october.toml
      raybundle calibration add result --photo images/DSC_0001.JPG
      raybundle calibration find images/DSC_0001.JPG
    """


for _subcommand in (convert, compare, add, list_, find, zoom):
    command.add_command(_subcommand)
