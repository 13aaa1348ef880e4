"""All benchmarks; figures with machine and versions into benchmarks/results/<name>.json."""

from __future__ import annotations

import json
import os
import platform
import subprocess
import sys
from importlib.metadata import version
from pathlib import Path

HERE = Path(__file__).resolve().parent


def machine() -> dict:
    """What the figures were made on."""
    cpu = platform.processor()
    info = Path("/proc/cpuinfo")
    if info.exists():
        cpu = next((line.split(":")[1].strip() for line in info.read_text().splitlines() if "model name" in line), cpu)
    return {
        "cpu": cpu,
        "cores": os.cpu_count(),
        "python": platform.python_version(),
        **{name: version(name) for name in ("raybundle", "numpy", "scipy")},
    }


def main() -> int:
    """Run what is asked for, or everything."""
    every = ["truth", "startup", "speed", "orient", "many_images", "verdicts", "fuzz_readers", "kills", "sanitizers"]
    names = sys.argv[1:] or every
    (HERE / "results").mkdir(exist_ok=True)
    failed = 0
    for name in names:
        done = subprocess.run([sys.executable, str(HERE / f"{name}.py")], capture_output=True, text=True, check=False)
        if done.returncode:
            failed = 1
            print(f"{name}: not run\n{done.stderr[-2000:]}", file=sys.stderr)
            continue
        try:
            result = {"machine": machine(), **json.loads(done.stdout)}
        except json.JSONDecodeError:
            print(f"{name}: prints no JSON; it writes its figures itself", file=sys.stderr)
            continue
        (HERE / "results" / f"{name}.json").write_text(json.dumps(result, indent=1) + "\n")
        print(f"{name}: benchmarks/results/{name}.json")
    return failed


if __name__ == "__main__":
    sys.exit(main())
