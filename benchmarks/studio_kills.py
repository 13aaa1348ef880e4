"""The studio's server killed 100 times while somebody measures.

    python benchmarks/studio_kills.py [KILLS] > benchmarks/results/studio_kills.json

No acknowledged action is lost, none counts twice; exit status 1 where one of them does not hold.
"""

import json
import shutil
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))


def main():
    from tests.studio.killed import measure_under_kills

    from raybundle.commands.orient import orient
    from raybundle.io.block.folder import read_block

    kills = int(sys.argv[1]) if len(sys.argv) > 1 else 100
    with tempfile.TemporaryDirectory() as folder:
        photos, project = Path(folder) / "photos", Path(folder) / "project"
        shutil.copytree(ROOT / "demo_data" / "portal" / "photos", photos)
        orient(sorted(photos.glob("*.jpg"))[:4], project, precise=False, report=False)
        began = time.monotonic()
        told = measure_under_kills(project, read_block(project / "result" / "block").images.ids[0], kills, seed=7)
    print(json.dumps({**told, "seconds": round(time.monotonic() - began, 1)}, indent=1))


if __name__ == "__main__":
    main()
