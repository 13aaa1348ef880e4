"""What share of all matches contradicts others (`ties/repeated.py`), on ordinary and on repeated things.

    python benchmarks/contradictions.py FOLDER ...

Prints a line for each folder of photographs: pairs that are believed, their matches, and the share that would give a
track two places in one photograph, a twentieth of its diagonal apart or more; the limit from which repeated structure
is looked for.  Adds them to benchmarks/results/contradictions.json under the folders' names; the repeated things are
those of `repeated_structure.py WORK`.
"""

from __future__ import annotations

import json
import sys
import tempfile
from pathlib import Path

from raybundle.matching.tracks import tracks_of
from raybundle.ties import repeated
from raybundle.workflows.orient import orient
from raybundle.workflows.orienting.stages import start

RESULTS = Path(__file__).resolve().parent / "results/contradictions.json"


class _Told(Exception):
    """Ends a run once the share is known."""


def measured(folder: Path) -> dict[str, float]:
    """The share of a folder of photographs; nothing is oriented."""
    found: dict[str, float] = {}

    def instead(pairs, features_xy, _names, diagonals, *_):
        share = repeated.contradicted(pairs, tracks_of(pairs, features_xy), diagonals)
        found.update(pairs=len(pairs), matches=sum(len(p.matches) for p in pairs), share=round(share, 4))
        raise _Told

    start.sound_pairs = instead
    with tempfile.TemporaryDirectory() as project:
        try:
            orient([folder], Path(project) / "project")
        except _Told:
            return found
    return found


def main() -> int:
    """Run all."""
    rows = json.loads(RESULTS.read_text(encoding="utf-8")) if RESULTS.exists() else {}
    for name in sys.argv[1:]:
        folder = Path(name)
        label = folder.parent.name if folder.name in {"images", "photos"} else folder.name
        rows[label] = measured(folder)
        print(label, rows[label], "limit", repeated.CONTRADICTED, flush=True)
        RESULTS.write_text(json.dumps(rows, indent=1, sort_keys=True) + "\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
