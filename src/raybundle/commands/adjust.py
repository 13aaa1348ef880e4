"""`raybundle adjust`: a block folder to a result folder with its report."""

from __future__ import annotations

from dataclasses import dataclass, fields
from pathlib import Path
from typing import TYPE_CHECKING

from raybundle.adjustment.options import AdjustmentOptions
from raybundle.numerics.progress import Progress, silent
from raybundle.settings import setting

if TYPE_CHECKING:
    from raybundle.adjustment.result import Adjustment


@dataclass(frozen=True, slots=True, kw_only=True)
class AdjustSettings(AdjustmentOptions):
    """The options of an adjustment, what is adjusted with them, and where the result goes."""

    block: Path
    """block folder"""
    out: Path
    """result folder; an older result is replaced"""
    report: bool = setting(True, "Leave out report.html and network.html.", flag="no-report")

    def options(self) -> AdjustmentOptions:
        """The options alone, as a result keeps them."""
        return AdjustmentOptions(**{f.name: getattr(self, f.name) for f in fields(AdjustmentOptions)})


def run_adjust(settings: AdjustSettings, progress: Progress = silent) -> Adjustment:
    """Read, adjust and write; raises InputError, NotSolvable."""
    from raybundle.io.block.folder import read_block  # noqa: PLC0415  (what computes is loaded after the help)
    from raybundle.report.write import write_result  # noqa: PLC0415
    from raybundle.results.folder import check_target  # noqa: PLC0415
    from raybundle.workflows.adjust import adjust  # noqa: PLC0415

    check_target(settings.out)
    done = adjust(read_block(settings.block, progress=progress), settings.options(), progress)
    write_result(done, settings.out, report="html" if settings.report else "none", progress=progress)
    return done
