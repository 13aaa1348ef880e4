"""Start-up: `raybundle --help` against `python -c "import numpy"`, and a whole roma command from files.

python benchmarks/startup.py [--repeat 9]
"""

from __future__ import annotations

import argparse
import json
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

DATA = Path(os.environ.get("RAYBUNDLE_DATA", Path(__file__).resolve().parents[2] / "shared/data"))


def seconds(command: list[str]) -> float:
    """Wall time of a command."""
    began = time.perf_counter()
    subprocess.run(command, check=True, capture_output=True)
    return time.perf_counter() - began


def main() -> None:
    """Print the figures as JSON."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--repeat", type=int, default=9)
    repeat = parser.parse_args().repeat
    script = str(Path(sys.executable).with_name("raybundle"))
    pairs = [(seconds([script, "--help"]), seconds([sys.executable, "-c", "import numpy"])) for _ in range(repeat)]
    result = {
        "help_s": statistics.median(a for a, _ in pairs),
        "import_numpy_s": statistics.median(b for _, b in pairs),
        "ratio": statistics.median(a / b for a, b in pairs),
    }
    roma = DATA / "blocks/roma"
    if roma.exists():
        runs = []
        for _ in range(5):
            folder = tempfile.mkdtemp()
            runs.append(seconds([script, "adjust", str(roma), "--out", f"{folder}/result"]))
            shutil.rmtree(folder)
        result["roma_s"] = {"median": statistics.median(runs), "all": runs}
    print(json.dumps(result, indent=1))


if __name__ == "__main__":
    main()
