"""Block folders of many image observations, as CSV and as Parquet: CPU seconds, peak memory, size; read in pieces.

Run: python benchmarks/block_tables.py [ROWS]          10^7 where nothing is said; a process for each;
writes benchmarks/results/block_tables.json
"""

import json
import platform
import subprocess
import sys
import tempfile
import time
from importlib import metadata
from pathlib import Path

import numpy as np
from runs import peak_mb

from raybundle.block import Block, Images, Observations, Points, Role
from raybundle.io.block.folder import read_block, write_block
from raybundle.io.block.pieces import read_in_pieces
from raybundle.planning.synthetic_networks import brown_camera

RESULTS = Path(__file__).parent / "results/block_tables.json"
SEEN, OF_IMAGE = 6, 1000
"""Images in which a point is seen, points in an image."""
WAYS = (("write", "csv"), ("read", "csv"), ("write", "parquet"), ("read", "parquet"), ("in pieces", "parquet"))


def block_of(rows):
    """Points in a row, each in consecutive images, by their names; measured to as many digits as a double has."""
    rng = np.random.default_rng(1)
    n, p = rows // OF_IMAGE, rows // SEEN
    first = np.sort(rng.integers(0, n - SEEN, p))
    image = (first[:, None] + np.arange(SEEN)).ravel().astype(np.int32)
    xy = rng.uniform(0, 4000, (len(image), 2))
    sigma = rng.choice([0.1, 0.2, 0.3, 0.5], (len(image), 1))
    nothing = np.full((n, 3, 3), np.nan)
    return Block(
        name="rows", about="", source="", licence="", length_unit="m", sigma0_apriori=1.0,
        cameras=(brown_camera(values={"c": 50.0}, size_px=(4000, 4000), pixel_mm=0.005, estimate=()),),
        images=Images(
            ids=tuple(f"IMG_{k:05d}.jpg" for k in range(n)), camera=np.zeros(n, np.int32),
            file=tuple(f"IMG_{k:05d}.jpg" for k in range(n)), centre=nothing[:, 0], rotation=nothing,
        ),
        observations=Observations(
            image=image, point=np.repeat(np.arange(p, dtype=np.int32), SEEN), xy_px=xy,
            cov_px2=np.concatenate([sigma**2, sigma**2, 0 * sigma], axis=1),
        ),
        points=Points(
            ids=tuple(f"t{k}" for k in range(p)), role=np.full(p, Role.TIE, np.int32),
            xyz=rng.uniform(0, 1000, (p, 3)), sigma=np.full((p, 3), np.nan),
        ),
    )  # fmt: skip


def one(what, kind, rows, folder):
    """What one of them takes; of writing beyond the block itself."""
    path = folder / kind
    block = block_of(rows) if what == "write" else None
    before, began = peak_mb(), time.process_time()
    if block is not None:
        write_block(block, path, tables=kind)
    elif what == "read":
        assert len(read_block(path).observations) == rows // SEEN * SEEN
    else:
        columns = read_in_pieces(path)
        assert sum(len(o) for _, o in columns.pieces_of_observations()) == columns.observations
    seconds, peak = time.process_time() - began, peak_mb()
    size = sum(f.stat().st_size for f in path.iterdir()) / 1e6
    told = {"CPU s": round(seconds, 2), "peak MB": round(peak), "MB of files": round(size, 1)}
    print(json.dumps(told | ({"MB beyond the block": round(peak - before)} if what == "write" else {})))


def main():
    """All ways, in processes of their own."""
    rows = int(float(sys.argv[1])) if len(sys.argv) > 1 else 10_000_000
    found = {}
    with tempfile.TemporaryDirectory() as folder:
        for what, kind in WAYS:
            call = [sys.executable, __file__, str(rows), what, kind, folder]
            done = subprocess.run(call, check=True, capture_output=True, text=True)
            found[f"{what}, {kind}"] = json.loads(done.stdout)
            print(f"{what}, {kind}: {found[f'{what}, {kind}']}", flush=True)
    versions = {"python": platform.python_version(), "pyarrow": metadata.version("pyarrow")}
    told = {"machine": platform.machine(), **versions, "rows": rows // SEEN * SEEN, **found}
    RESULTS.write_text(json.dumps(told, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) > 2:
        one(sys.argv[2], sys.argv[3], int(sys.argv[1]), Path(sys.argv[4]))
    else:
        main()
