"""One orientation by pycolmap on the CPU, defaults but for the number of threads; prints one JSON line.

    peer_colmap.py PHOTOS WORK [--threads 2] [--pinhole fx,fy,cx,cy] [--cameras single|auto] [--both]

--both runs the global mapper as well and takes the result with more photographs.  --pinhole gives the interior
orientation and holds it; without it pycolmap takes EXIF or a default and estimates.
Rotations are object to camera with y down and z forward, pixels have their origin at the outer corner of the first.
"""

from __future__ import annotations

import argparse
import json
import shutil
import time
from pathlib import Path

import pycolmap


def images_of(model: pycolmap.Reconstruction) -> dict:
    """Centres and rotations of the oriented photographs of a model."""
    return {
        i.name: {"centre": list(i.projection_center()), "rotation": i.cam_from_world().rotation.matrix().tolist()}
        for i in model.images.values()
        if i.has_pose
    }


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("photos", type=Path)
    parser.add_argument("work", type=Path)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--pinhole", default="")
    parser.add_argument("--cameras", choices=["single", "auto"], default="single")
    parser.add_argument("--both", action="store_true")
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
    mode = pycolmap.CameraMode.SINGLE if options.cameras == "single" else pycolmap.CameraMode.AUTO
    pycolmap.extract_features(
        database, options.photos, camera_mode=mode, reader_options=reader,
        extraction_options=extraction, device=pycolmap.Device.cpu,
    )  # fmt: skip
    pycolmap.match_exhaustive(database, matching_options=matching, device=pycolmap.Device.cpu)
    found = pycolmap.incremental_mapping(database, options.photos, options.work / "sparse", options=mapping)
    models = {"incremental": list(found.values())}
    before_global = time.process_time()
    if options.both:
        every = pycolmap.GlobalPipelineOptions()
        every.num_threads = options.threads
        models["global"] = list(
            pycolmap.global_mapping(database, options.photos, options.work / "global", options=every).values()
        )
    largest = {name: max(of, key=lambda r: r.num_reg_images()) for name, of in models.items() if of}
    best = max(largest.values(), key=lambda r: r.num_reg_images(), default=None)
    told = {
        "version": pycolmap.__version__,
        # models of the incremental mapper may share images
        "registered": {
            name: len({i.name for m in of for i in m.images.values() if i.has_pose}) for name, of in models.items()
        },
        "global_cpu_s": time.process_time() - before_global,
        "mappers": {name: images_of(model) for name, model in largest.items()},
    }
    if best is None:
        print(json.dumps({**told, "oriented": 0, "images": {}}))
        return
    images = images_of(best)
    print(
        json.dumps(
            {
                **told,
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
