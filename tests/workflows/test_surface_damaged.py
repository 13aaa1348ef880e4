"""What is kept of a surface is damaged, or deleted: one run makes it again, with the same bits."""

import numpy as np
import pytest

from raybundle.commands.surface import surface
from raybundle.pipeline.store import Folder

BOX = (-0.4, -0.3, 0.3, 0.4)
WRITTEN = ("points.ply", "heights.tif", "heights_sigma.tif")


@pytest.mark.parametrize(
    ("jobs", "ways"), [(1, (0,)), pytest.param(2, (0, 1, 2), marks=pytest.mark.long)]
)  # fmt: skip
def test_one_run_makes_again_what_is_damaged_or_gone(half, tmp_path, jobs, ways):
    pytest.importorskip("rasterio")

    def run():
        return surface(
            half / "block", tmp_path / "s", photos=(half,), density="4", jobs=jobs, dsm=0.05, extent=BOX
        )  # fmt: skip

    assert not any("made again" in r for r in run().remarks)
    before = {name: (tmp_path / "s" / name).read_bytes() for name in WRITTEN}
    files = sorted((tmp_path / "s/work/cache").rglob("*.npz"))
    assert len(files) > 15
    for begin in ways:
        for k, path in enumerate(files):
            data = bytearray(path.read_bytes())
            if (k + begin) % 3 == 0:
                path.write_bytes(data[: len(data) // 2])
            elif (k + begin) % 3 == 1:
                rng = np.random.default_rng(k)
                for at in rng.integers(0, len(data), max(20, len(data) // 1000)).tolist():
                    data[at] ^= 0xFF
                path.write_bytes(data)
            else:
                path.unlink()
        done = run()
        (told,) = [m for r in done.remarks for m in r.messages if m.code == "surface_remark.remade"]
        assert told.values["n"] > 0
        assert {name: (tmp_path / "s" / name).read_bytes() for name in WRITTEN} == before
        store = Folder(tmp_path / "s/work/cache")
        assert all(store.load(path.stem) is not None for path in files)
    assert not any("made again" in r for r in run().remarks)
