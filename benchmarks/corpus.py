"""Public photographs of all kinds: does each set end as a result, as complete as a peer's, with true sigmas?

    RAYBUNDLE_PEER_PYTHON=peer/bin/python python benchmarks/corpus.py [--half A|B] [--sets NAME ...]
        [--photos FOLDER] [--work FOLDER] [--no-peer] [--splits 20] [--again] [--results FILE] [--limit-s 1800]

`corpus.toml` lists the sets; FOLDER/NAME holds the photographs of one, and what is not there is fetched as
`raybundle datasets get` does.  The half of a set follows from the hash of its name: methods and thresholds are fixed
on A, B is run to judge them.  A set that was run is not run again unless --again says so (its project is kept, and
stages that are unchanged are reused: such a run says nothing of CPU seconds, and takes no part in their ratio).  Prints
JSON; WORK/corpus.md is a table of it, with all messages below; --results FILE keeps the figures without the messages.
"""

from __future__ import annotations

import argparse
import csv
import hashlib
import json
import os
import statistics
import sys
import tomllib
from collections import Counter
from pathlib import Path

import numpy as np
from real_sigmas import of_halves
from runs import errors, measured, of_block

from raybundle.errors import RaybundleError
from raybundle.io.datasets import dataset, fetch

HERE = Path(__file__).resolve().parent
LISTING = HERE / "corpus.toml"
LEAST = 10
"""Photographs from which on a set is halved."""
AGREE = 0.01
"""Two results are one where their centres agree to this share of the extent."""


def half_of(name: str) -> str:
    """A or B, by the hash of the name."""
    return "AB"[hashlib.sha256(name.encode()).digest()[0] % 2]


def photographs_of(name: str, there: Path | None, work: Path) -> Path:
    """The folder of a set's photographs, fetched if it is nowhere."""
    if there is not None and (there / name).is_dir():
        return there / name
    folder = work / "photos" / name
    fetch(dataset(name, LISTING), folder)
    return folder


def ours(photos: Path, work: Path, control: str, limit_s: float) -> dict:
    """One run of `raybundle orient`."""
    project = work / "project"
    command = [str(Path(sys.executable).parent / "raybundle"), "orient", str(photos), "--out", str(project)]
    given = ["--control", str(photos / control)] if control else []
    run = measured([*command, *given], may_fail=True, limit_s=limit_s)
    told = {"status": run["status"], "memory_mb": run["memory_mb"], "printed": run["output"], "stderr": run["errors"]}
    if not (project / "result/result.json").exists():
        return {**told, "oriented": 0, "cpu_s": run["cpu_s"]}
    result = json.loads((project / "result/result.json").read_text())
    images = result["images"]
    stages = {s["name"]: s["cpu_seconds"] for s in result["stages"]}
    reused = any(s["from_cache"] for s in result["stages"])
    return {
        **told,
        "given": images["given"], "oriented": images["oriented"], "not_oriented": images["not_oriented"],
        "parts": [
            sum(bool(row["X"]) for row in csv.DictReader((folder / "images.csv").read_text().splitlines()))
            for folder in sorted(project.glob("result*"))
        ],
        "sigma0": result["sigma0"], "image_sigma_px": result["image_sigma_px"], "points": result["points_count"],
        "observations": result["image_points"], "measurements": result["measurements"],
        "noise": result["noise"], "warnings": result["warnings"],
        "cameras": {
            k: {s: [p["value"], p["std"]] for s, p in parameters.items() if p["std"]}
            for k, parameters in result["cameras"].items()
        },
        "cpu_s": run["cpu_s"], "stages_cpu_s": stages, "reused": reused,
    }  # fmt: skip


def peer(photos: Path, work: Path, cameras: str, limit_s: float) -> dict:
    """pycolmap with both of its mappers."""
    python = os.environ["RAYBUNDLE_PEER_PYTHON"]
    command = [python, str(HERE / "peer_colmap.py"), str(photos), str(work / "peer"), "--both", "--cameras", cameras]
    run = measured(command, may_fail=True, limit_s=limit_s)
    lines = run["output"].strip().splitlines()
    if run["status"] or not lines:
        return {"status": run["status"], "oriented": 0, "cpu_s": run["cpu_s"], "stderr": run["errors"][-1000:]}
    told = json.loads(lines[-1])
    return {"status": 0, **told, "cpu_s": run["cpu_s"] - told["global_cpu_s"], "memory_mb": run["memory_mb"]}


def beside(here: dict, images: dict) -> dict:
    """How far two results are apart: centres as a share of their extent, directions."""
    both = [n for n in here if n in images]
    found = errors(here, images)
    if not found:
        return {}
    C = np.array([images[n]["centre"] for n in both])
    extent = float(np.linalg.norm(np.ptp(C, axis=0)))
    return {
        "compared": found["compared"],
        "centres_share": found["centres_rms_mm"] / 1000 / extent,
        "angles_deg": found["angles_mean_deg"],
    }


def judged(row: dict) -> tuple[str, str]:
    """What is known of a result, and its verdict.

    Right or wrong where both mappers of the peer are less than AGREE apart: the result is within or beyond of both.
    """
    p, o = row.get("pycolmap", {}), row["raybundle"]
    shares = [a.get("centres_share") for a in (p.get("mappers_apart", {}), *row.get("apart_from", {}).values())]
    known = "unknown"
    if len(shares) == 3 and None not in shares and shares[0] < AGREE:
        known = {0: "right", 2: "wrong"}.get(sum(s > AGREE for s in shares[1:]), "unknown")
    severities = {w["severity"] for w in o.get("warnings", [])}
    return known, "fault" if o["status"] or "fault" in severities else (
        "caution" if "caution" in severities else "usable"
    )


def one_set(name: str, entry: dict, asked: argparse.Namespace) -> dict:
    """A set's row."""
    work = asked.work / name
    work.mkdir(parents=True, exist_ok=True)
    photos = photographs_of(name, asked.photos, asked.work)
    row: dict = {"half": half_of(name), "kind": entry["kind"], "raybundle": {}}
    row["raybundle"] = ours(photos, work, entry.get("control", ""), asked.limit_s)
    kept = work / "peer.json"
    if not asked.no_peer:
        if not kept.exists():
            kept.write_text(json.dumps(peer(photos, work, entry.get("cameras", "single"), asked.limit_s)))
        told = json.loads(kept.read_text())
        mappers, images = told.pop("mappers", {}), told.pop("images", {})
        told["mappers_apart"] = beside(*mappers.values()) if len(mappers) == 2 else {}
        if row["raybundle"]["oriented"]:
            here = of_block(work / "project/result/block")
            row["apart"] = beside(here, images)
            row["apart_from"] = {mapper: beside(here, of) for mapper, of in mappers.items()}
        row["pycolmap"] = told
    if asked.splits and row["raybundle"]["oriented"] >= LEAST:
        try:
            row["halves"] = of_halves(work / "project/result", asked.splits)
        except RaybundleError as error:
            row["halves"] = {"failed": str(error)}
    return row


def summary(rows: dict) -> dict:
    """The figures that acceptance asks for."""
    both = {n: r for n, r in rows.items() if r.get("pycolmap")}
    joined = {n: (own(r), best_peer(r)) for n, r in both.items()}
    halves = [h["interior_fields"] for r in rows.values() if (h := r.get("halves", {})).get("interior_fields")]
    ratios = [q for r in both.values() if (q := cpu_ratio(r)) is not None]
    return {
        "sets": len(rows),
        "beside_a_peer": len(joined),
        "nothing_where_the_peer_has_something": [n for n, (a, b) in joined.items() if b and not a],
        "at_least_the_peers": sum(a >= b for a, b in joined.values()),
        "fewer_by_more_than_5_percent": [n for n, (a, b) in joined.items() if a < 0.95 * b],
        "cpu_ratio_median": statistics.median(ratios) if ratios else None,
        "halved": len(halves),
        "halves_median": statistics.median(h["median"] for h in halves) if halves else None,
        "halves_medians_above_2": sum(h["median"] > 2 for h in halves),
        "halves_splits_above_8": sum(h["max"] > 8 for h in halves),
        "verdicts": dict(Counter(", ".join(judged(r)) for r in rows.values())),
    }


def cpu_ratio(row: dict) -> float | None:
    """CPU seconds by the peer's; None where either was not measured as a whole."""
    o, p = row["raybundle"], row.get("pycolmap", {})
    return o["cpu_s"] / p["cpu_s"] if p.get("cpu_s") and not o.get("reused") else None


def figures(row: dict) -> dict:
    """A row without its messages."""
    o, p, h = row["raybundle"], row.get("pycolmap", {}), row.get("halves", {})
    names = ("given", "oriented", "parts", "sigma0", "points", "observations", "cpu_s", "reused", "memory_mb")
    return {
        **{k: o[k] for k in names if k in o},
        "pycolmap": {k: p[k] for k in ("registered", "cpu_s", "memory_mb") if k in p},
        "apart": row.get("apart", {}),
        "apart_from": row.get("apart_from", {}),
        "mappers_apart": p.get("mappers_apart", {}),
        "judged": judged(row),
        "faults": [w["code"] for w in o.get("warnings", []) if w["severity"] == "fault"],
        "halves": {k: v for k, v in h.items() if k in ("splits", "not_solvable") or isinstance(v, dict)},
    }


def own(row: dict) -> int:
    """Photographs that raybundle orients, in all its parts."""
    return sum(row["raybundle"].get("parts", [])) or row["raybundle"]["oriented"]


def best_peer(row: dict) -> int:
    """Photographs that the peer registers, by the better of its mappers, in all its parts."""
    return max(row.get("pycolmap", {}).get("registered", {}).values(), default=0)


def table(rows: dict) -> str:
    """The rows as a table for people, and every message."""
    head = ["set", "half", "photographs", "raybundle", "pycolmap", "sigma0", "points"]
    head += ["CPU s", "CPU ratio", "MB", "apart", "halves"]
    lines = [" | ".join(head), "|".join(["---"] * len(head))]
    for name, r in rows.items():
        o, h = r["raybundle"], r.get("halves", {})
        share = "" if (ratio := cpu_ratio(r)) is None else f"{ratio:.2f}"
        apart = f"{r['apart']['centres_share']:.4f}, {r['apart']['angles_deg']:.2f}°" if r.get("apart") else ""
        half = (
            f"{h['interior_fields']['median']:.2f}, {h['interior_fields']['max']:.1f}" if "interior_fields" in h else ""
        )
        parts = "+".join(map(str, o.get("parts", []))) or o["oriented"]
        cells = [
            name, r["half"], o.get("given", ""), parts, best_peer(r) or "", f"{o.get('sigma0') or 0:.2f}",
            o.get("points", 0), f"{o['cpu_s']:.0f}", share, f"{o['memory_mb']:.0f}", apart, half,
        ]  # fmt: skip
        lines.append(" | ".join(map(str, cells)))
    for name, r in rows.items():
        o = r["raybundle"]
        lines += ["", f"## {name} (status {o['status']})", ""]
        lines += [f"- {w['severity']} `{w['code']}`: {w['message']}" for w in o.get("warnings", [])]
        lines += [f"    {line}" for line in o["stderr"].splitlines()[-3:]] if o["status"] else []
    return "\n".join(lines) + "\n"


def main() -> int:
    """All sets that are asked for."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--half", choices=["A", "B"])
    parser.add_argument("--sets", nargs="*", default=[])
    parser.add_argument("--photos", type=Path)
    parser.add_argument("--work", type=Path, default=HERE / "work" / "corpus")
    parser.add_argument("--no-peer", action="store_true")
    parser.add_argument("--splits", type=int, default=20)
    parser.add_argument("--again", action="store_true")
    parser.add_argument("--results", type=Path)
    parser.add_argument("--limit-s", type=float, default=1800.0)
    asked = parser.parse_args()
    asked.no_peer |= "RAYBUNDLE_PEER_PYTHON" not in os.environ
    rows: dict = {}
    for name, entry in tomllib.loads(LISTING.read_text()).items():
        if (asked.sets and name not in asked.sets) or (asked.half and half_of(name) != asked.half):
            continue
        kept = asked.work / name / "row.json"
        if asked.again or not kept.exists():
            try:
                row = one_set(name, entry, asked)
            except RaybundleError as error:
                print(f"{name}: {error}", file=sys.stderr)
                continue
            kept.write_text(json.dumps(row))
        rows[name] = json.loads(kept.read_text())
        told = rows[name]["raybundle"]
        print(f"{name}: {told['oriented']} oriented, status {told['status']}", file=sys.stderr, flush=True)
        (asked.work / "corpus.md").write_text(table(rows))
    if asked.results is not None:
        kept = {"half": asked.half, "summary": summary(rows), "sets": {n: figures(r) for n, r in rows.items()}}
        asked.results.write_text(json.dumps(kept, indent=1) + "\n")
    print(json.dumps({"summary": summary(rows), "sets": rows}, indent=1))
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
