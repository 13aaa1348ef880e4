"""The ledger: true errors over stated standard deviations, set by set, with the peers beside us.

    python -m ledger            in benchmarks/; or `make ledger`

One TOML file in `sets/` is one set.  `judges/` has one file for each kind of truth.  One result file is written for
each set (benchmarks/results/ledger/NAME.json), and docs/ledger.md is made from these files.
"""

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
RESULTS = ROOT / "benchmarks" / "results" / "ledger"
SETS = Path(__file__).resolve().parent / "sets"
for folder in (ROOT, ROOT / "tools", ROOT / "benchmarks"):  # scenes of the tests; truth of rendered sets; halves
    if str(folder) not in sys.path:
        sys.path.append(str(folder))
