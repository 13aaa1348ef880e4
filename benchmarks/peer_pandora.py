"""One rectified pair by pandora with libSGM: census, semi-global matching, parabolas, cross check.

    peer_pandora.py LEFT.tif RIGHT.tif LOWEST HIGHEST WORK

WORK/disparity.npy holds columns (h, w) float32 by which the right picture's place lies from the left one's, NaN where
there is none; prints one JSON line.  Its settings are those of its own examples, its penalties the default ones; both
pictures are padded with zeros, which count as no data.
"""

from __future__ import annotations

import argparse
import json
import time
from importlib.metadata import version
from pathlib import Path

import numpy as np
import pandora
import rasterio
from pandora.constants import Criteria


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("left", type=Path)
    parser.add_argument("right", type=Path)
    parser.add_argument("lowest", type=int)
    parser.add_argument("highest", type=int)
    parser.add_argument("work", type=Path)
    given = parser.parse_args()
    given.work.mkdir(parents=True, exist_ok=True)
    pipeline = {
        "matching_cost": {"matching_cost_method": "census", "window_size": 5, "subpix": 1},
        "optimization": {"optimization_method": "sgm", "overcounting": False},
        "disparity": {"disparity_method": "wta", "invalid_disparity": "NaN"},
        "refinement": {"refinement_method": "vfit"},
        "filter": {"filter_method": "median", "filter_size": 3},
        "validation": {"validation_method": "cross_checking_accurate"},
        "filter.final": {"filter_method": "median", "filter_size": 3},
    }
    settings = {
        "input": {
            "left": {"img": str(given.left), "nodata": 0, "disp": [given.lowest, given.highest]},
            "right": {"img": str(given.right), "nodata": 0},
        },
        "pipeline": pipeline,
    }
    path = given.work / "settings.json"
    path.write_text(json.dumps(settings))
    began = time.process_time()
    pandora.main(str(path), str(given.work), verbose=False)
    seconds = time.process_time() - began
    with rasterio.open(given.work / "left_disparity.tif") as tif:
        found = tif.read(1).astype(np.float32)
    with rasterio.open(given.work / "left_validity_mask.tif") as tif:
        found[(tif.read(1) & int(Criteria.PANDORA_MSK_PIXEL_INVALID)) != 0] = np.nan
    np.save(given.work / "disparity.npy", found)
    print(json.dumps({"cpu_s": round(seconds, 1), "version": version("pandora")}))


if __name__ == "__main__":
    main()
