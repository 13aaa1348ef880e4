"""What each kind of start keeps of the rays, how near, and how likely that is: by what `orient` chooses among them.

    python benchmarks/starts.py PHOTOS PROJECT [PHOTOS PROJECT ...]

PROJECT is a folder that `raybundle orient PHOTOS --out PROJECT` has left; it is copied, and its features and pairs are
used.  Camera constants that nothing tells are tried at several factors of the guess, beyond what `orient` tries.  Adds
to benchmarks/results/starts.json: photographs oriented, share of the rays kept, standard deviation [px], logarithm of
the likelihood per ray, camera constants [px].
"""

import json
import shutil
import sys
import tempfile
from dataclasses import replace
from pathlib import Path

import numpy as np

from raybundle.adjustment.system.predict import residuals_px
from raybundle.errors import NoOrientation
from raybundle.numerics.progress import silent
from raybundle.ties import start as tie_start
from raybundle.workflows.orient import OrientOptions, orient
from raybundle.workflows.orienting.stages import start as stage

RESULTS = Path(__file__).resolve().parent / "results" / "starts.json"
FACTORS = (0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.2, 1.65)


class Told(Exception):
    """The block of all tracks is there."""


def raw_block(photos, project):
    """The block of tracks that a start is given."""
    found = []

    def instead(raw, *_):
        found.append(raw)
        raise Told

    kept, stage.start_components = stage.start_components, instead
    with tempfile.TemporaryDirectory() as folder:
        try:
            orient([photos], Path(shutil.copytree(project, Path(folder) / "project")), OrientOptions(redo_from="start"))
        except Told:
            return found[0]
        finally:
            stage.start_components = kept
    raise SystemExit(f"{photos}: no start was made")


def started(raw, way, factor):
    """One start: what it keeps and how likely that is."""
    cameras = tuple(
        replace(
            c, estimate=tie_start.free_at_start(c),
            values={**c.values, c.sensor.scale_symbol: c.values[c.sensor.scale_symbol] * factor},
        )
        for c in raw.cameras
    )  # fmt: skip
    try:
        found = tie_start.cleaned(raw, way(replace(raw, cameras=cameras), silent), 1, silent)
    except NoOrientation as error:
        return {"none": str(error).splitlines()[0]}
    block = found[0]
    off = np.linalg.norm(residuals_px(block, np.arange(len(block.observations))), axis=1)
    seen = np.unique(block.images.camera[block.images.oriented]).tolist()
    return {
        "oriented": int(block.images.oriented.sum()),
        "kept": round(len(block.observations) / len(raw.observations), 3),
        "sigma_px": round(float(np.median(off)) / tie_start.RAYLEIGH, 2),
        "log_likelihood": round(tie_start.likelihood(found) / len(raw.observations), 2),
        "c_px": [round(c.values[c.sensor.scale_symbol] / c.pixel_mm[0]) for c in (block.cameras[k] for k in seen[:4])],
    }


def main():
    rows = json.loads(RESULTS.read_text()) if RESULTS.is_file() else {}
    for photos, project in zip(sys.argv[1::2], sys.argv[2::2], strict=True):
        raw = raw_block(Path(photos), Path(project))
        free = bool(tie_start.unknown_constants(raw)) or len(raw.cameras) == 1
        rows[Path(photos).name] = row = {}
        for factor in FACTORS if free else (1.0,):
            for name, way in (("growing", tie_start.by_growing), ("averaging", tie_start.by_averaging)):
                row[f"{name} {factor:g}"] = started(raw, way, factor)
                print(Path(photos).name, name, factor, row[f"{name} {factor:g}"], flush=True)
        RESULTS.write_text(json.dumps(rows, indent=1) + "\n")


if __name__ == "__main__":
    main()
