"""One orientation by pycolmap on the CPU, defaults but for the number of threads; prints one JSON line.

    peer_colmap.py PHOTOS WORK [--threads 2] [--pinhole fx,fy,cx,cy]

--pinhole gives the interior orientation and holds it; without it pycolmap takes EXIF or a default and estimates.
Rotations are object to camera with y down and z forward, pixels have their origin at the outer corner of the first.
"""

from __future__ import annotations

import argparse
import json
import shutil
from pathlib import Path

import pycolmap


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("photos", type=Path)
    parser.add_argument("work", type=Path)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--pinhole", default="")
    options = parser.parse_args()
    shutil.rmtree(options.work, ignore_errors=True)
    options.work.mkdir(parents=True)
    database = options.work / "database.db"
    reader = pycolmap.ImageReaderOptions()
    if options.pinhole:
        reader.camera_model, reader.camera_params = "PINHOLE", options.pinhole
    extraction = pycolmap.FeatureExtractionOptions()
    extraction.num_threads, extraction.use_gpu = options.threads, False
    matching = pycolmap.FeatureMatchingOptions()
    matching.num_threads, matching.use_gpu = options.threads, False
    mapping = pycolmap.IncrementalPipelineOptions()
    mapping.num_threads = options.threads
    if options.pinhole:
        mapping.ba_refine_focal_length = mapping.ba_refine_extra_params = False
    pycolmap.extract_features(
        database, options.photos, camera_mode=pycolmap.CameraMode.SINGLE, reader_options=reader,
        extraction_options=extraction, device=pycolmap.Device.cpu,
    )  # fmt: skip
    pycolmap.match_exhaustive(database, matching_options=matching, device=pycolmap.Device.cpu)
    found = pycolmap.incremental_mapping(database, options.photos, options.work / "sparse", options=mapping)
    best = max(found.values(), key=lambda r: r.num_reg_images(), default=None)
    if best is None:
        print(json.dumps({"version": pycolmap.__version__, "oriented": 0, "images": {}}))
        return
    images = {}
    for image in best.images.values():
        if not image.has_pose:
            continue
        R = image.cam_from_world().rotation.matrix()
        images[image.name] = {"centre": list(image.projection_center()), "rotation": R.tolist()}
    print(
        json.dumps(
            {
                "version": pycolmap.__version__,
                "oriented": len(images),
                "images": images,
                "mean_residual_px": best.compute_mean_reprojection_error(),
                "image_observations": best.compute_num_observations(),
                "object_points": best.num_points3D(),
                "interior": {c.model.name: list(c.params) for c in best.cameras.values()},
            }
        )
    )


if __name__ == "__main__":
    main()
