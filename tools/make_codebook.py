"""The words that come with the package, learnt from public photographs of other things than those that tests judge by.

    python tools/make_codebook.py FOLDER --version 1

FOLDER holds the photographs of each set of SETS in a folder of that name.  Only the words are shipped, means of
thousands of descriptors each, with the list of sources (docs/decisions/0034-pairs-of-large-sets.md).  Photographs are
reduced to 2000 px; of each set the same number of descriptors is taken, so that no kind of object outweighs the others.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

import cv2
import numpy as np

from raybundle.matching.descriptors import directions
from raybundle.matching.features import feature_number
from raybundle.matching.methods import feature_method
from raybundle.matching.signatures import BYTES_OF_ONE, DESCRIBED, WORDS, widest, words_of

METHOD = "rootsift"
OUT = Path(__file__).resolve().parents[1] / "src" / "raybundle" / "matching" / "codebooks" / f"{METHOD}.npz"
LONGEST_PX = 2000
MOST = 8000
"""Features of a photograph."""
EACH = 6000
"""Descriptors of a set."""
SETS = {
    "seneca": (60, "OpenDroneMap/odm_data_seneca 9220acf", "CC0 1.0"),
    "caliterra": (40, "OpenDroneMap/odm_data_caliterra bec3dc7", "CC0 1.0"),
    "brighton-beach": (18, "pierotofy/drone_dataset_brighton_beach 9506a9b", "BSD-2-Clause"),
    "banana": (16, "pierotofy/dataset_banana 2778294", "MIT"),
    "buddha": (13, "alicevision/dataset_buddha 9067f67", "CC BY 4.0"),
    "lund": (29, "mapillary/OpenSfM 238744c, data/lund", "BSD-2-Clause"),
    "berlin": (3, "mapillary/OpenSfM 238744c, data/berlin", "BSD-2-Clause"),
    "skull": (
        30,
        "KarmenKei/HiimelOyunUhaan 51865e8, bd2/photogrammetry_backend/jobs/skull01, by alansartlog",
        "CC BY 4.0",
    ),
}
"""Photographs of each, the first by name; repository on GitHub with commit; licence."""


def descriptors(path: Path) -> np.ndarray:
    """(n, 128) stored descriptors of the features from which signatures are made."""
    grey = cv2.imread(str(path), cv2.IMREAD_GRAYSCALE | cv2.IMREAD_IGNORE_ORIENTATION)
    if grey is None:
        raise SystemExit(f"{path}: cannot be read")
    factor = LONGEST_PX / max(grey.shape)
    if factor < 1:
        grey = cv2.resize(grey, None, fx=factor, fy=factor, interpolation=cv2.INTER_AREA)
    found = feature_method(METHOD).detect(grey, feature_number(grey.shape[1], grey.shape[0], MOST))
    return found.descriptors[widest(found, DESCRIBED)]


def main() -> int:
    """Learn the words and write them."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--version", type=int, required=True, help="a number higher than that of the words before")
    parser.add_argument("--out", type=Path, default=OUT)
    parser.add_argument("--without", nargs="*", default=[], help="sets to leave out, to judge by them")
    asked = parser.parse_args()
    cv2.setNumThreads(1)
    rng = np.random.default_rng(1)
    samples: list[np.ndarray] = []
    for name, (count, _, _) in SETS.items():
        if name in asked.without:
            continue
        files = sorted(p for p in (asked.folder / name).iterdir() if p.suffix.lower() in (".jpg", ".jpeg", ".png"))
        if len(files) < count:
            raise SystemExit(f"{asked.folder / name}: {len(files)} photographs, {count} wanted")
        rows = np.vstack([descriptors(p) for p in files[:count]])
        samples.append(directions(rows[rng.permutation(len(rows))[:EACH]]))
        print(f"{name}: {count} photographs, {len(rows)} descriptors", file=sys.stderr)
    words = np.minimum(np.round(words_of(samples, WORDS) * BYTES_OF_ONE), 255).astype(np.uint8)
    about = "; ".join(f"{source} ({licence})" for n, (_, source, licence) in SETS.items() if n not in asked.without)
    asked.out.parent.mkdir(exist_ok=True)
    np.savez_compressed(asked.out, words=words, version=np.array(asked.version), about=np.array(about))
    return 0


if __name__ == "__main__":
    sys.exit(main())
