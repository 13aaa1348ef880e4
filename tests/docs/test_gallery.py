"""Notebooks of published examples: they run, print what is stored in them, and are pages of the documentation."""

import importlib.util
import json
import re
import subprocess
import sys
from pathlib import Path

import pytest

from tests.conftest import DATA

pytest.importorskip("nbclient")
pytest.importorskip("ipykernel")
ROOT = Path(__file__).resolve().parents[2]
GALLERY = ROOT / "docs/gallery"


def tool(name):
    """A script of tools/ as a module."""
    spec = importlib.util.spec_from_file_location(name, ROOT / f"tools/{name}.py")
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    spec.loader.exec_module(module)
    return module


gallery = tool("generate_gallery")
NOTEBOOKS = gallery.notebooks()
WITHOUT_DATA = {"opencv-chessboard", "self-calibrating-bundle"}
"""Those that may end because public data are not here"""


def read(path):
    return gallery.nbformat.read(path, as_version=4)


LONG = {"opencv-chessboard"}


@pytest.mark.parametrize(
    "path", [pytest.param(p, marks=pytest.mark.long if p.stem in LONG else (), id=p.stem) for p in NOTEBOOKS]
)
def test_a_notebook_runs_and_prints_what_is_stored(path, monkeypatch):
    monkeypatch.setenv("RAYBUNDLE_DATA", str(DATA))
    done = gallery.execute(path)
    if done.skipped is not None:
        assert path.stem in WITHOUT_DATA
        assert done.skipped.startswith("not run: ")
        pytest.skip(done.skipped)
    assert gallery.stale(gallery.printed(read(path)), gallery.printed(done.notebook)) == []


def test_most_need_nothing_but_the_repository():
    assert len(NOTEBOOKS) >= 7
    assert len([p for p in NOTEBOOKS if p.stem not in WITHOUT_DATA]) >= 5


def test_what_is_not_here_is_told(monkeypatch, tmp_path):
    monkeypatch.setenv("RAYBUNDLE_DATA", str(tmp_path))
    done = gallery.execute(GALLERY / "self-calibrating-bundle.ipynb")
    assert done.skipped is not None
    assert "RAYBUNDLE_DATA" in done.skipped
    assert gallery.printed(done.notebook) == gallery.printed(read(GALLERY / "self-calibrating-bundle.ipynb"))


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda p: p.stem)
def test_a_notebook_is_stored_so_that_differences_are_read(path):
    """Stable names of cells, counts in order, no error, no time, nothing of the machine where it was run."""
    notebook = json.loads(path.read_text(encoding="utf-8"))
    assert [c["id"] for c in notebook["cells"]] == [
        f"{k:02d}-{c['cell_type']}" for k, c in enumerate(notebook["cells"], 1)
    ]
    code = [c for c in notebook["cells"] if c["cell_type"] == "code"]
    assert [c["execution_count"] for c in code] == list(range(1, len(code) + 1))
    assert all(set(c["metadata"]) <= {"tags"} for c in notebook["cells"])
    kinds = {o["output_type"] for c in code for o in c["outputs"]}
    assert kinds <= {"stream", "execute_result", "display_data"}
    text = path.read_text(encoding="utf-8")
    assert not re.search(r"/home/|/work/|/tmp/|\.venv|site-packages|iopub", text)
    assert any("compare(" in "".join(c["source"]) for c in code)
    assert "assert" in "".join("".join(c["source"]) for c in code)


def test_a_published_number_that_is_missed_is_named(monkeypatch, capsys):
    monkeypatch.syspath_prepend(str(GALLERY))
    import published

    published.compare([("c", "1.500", 1.50049), ("e", "-2.50e-04", -2.503e-4)])
    assert "+0.49 units" in capsys.readouterr().out
    with pytest.raises(AssertionError, match=r": c$"):
        published.compare([("c", "1.500", 1.50051), ("x0", "0.1", 0.1)])
    published.compare([("c", "1.500", 1.50051)], units=1)
    with pytest.raises(AssertionError):
        published.compare([("c", "1.500", float("nan"))])


@pytest.mark.parametrize(
    ("old", "new", "same"),
    [
        ("X0 914260.4219  914260.421863  -0.37 units", "X0 914260.4219  914260.421860  -0.40 units", True),
        ("fx 535.9157", "fx 535.9164", False),
        ("redundancy 18", "redundancy 17", False),
        ("k1 -0.2664", "k2 -0.2664", False),
        ("1.5e-05", "1.6e-05", True),
        ("1.5e-05", "2.5e-05", False),
        ("a\nb", "a", False),
    ],
)
def test_stale_outputs_are_seen_and_the_last_digits_of_a_processor_are_not(old, new, same):
    assert (gallery.stale(old, new) == []) is same


def test_a_number_that_changes_in_a_notebook_is_seen():
    """As if raybundle computed something else: the stored output differs in a digit that is printed."""
    notebook = read(GALLERY / "space-resection.ipynb")
    stored = gallery.printed(notebook)
    assert "914260.421863" in stored
    changed = stored.replace("914260.421863", "914260.431863")
    assert len(gallery.stale(stored, changed)) >= 2


def test_every_notebook_is_a_page_that_the_index_tells():
    nav = (ROOT / "mkdocs.yml").read_text(encoding="utf-8")
    index = (GALLERY / "index.md").read_text(encoding="utf-8")
    for path in NOTEBOOKS:
        assert f": gallery/{path.name}\n" in nav
        assert f"({path.name})" in index
    assert "gallery/index.md" in (ROOT / "docs/index.md").read_text(encoding="utf-8")
    assert "docs/gallery/index.md" in (ROOT / "README.md").read_text(encoding="utf-8")


def test_links_of_notebooks_lead_somewhere():
    for path in NOTEBOOKS:
        text = "\n".join("".join(c["source"]) for c in read(path).cells if c["cell_type"] == "markdown")
        for link in re.findall(r"\]\(([^)#\s]+\.(?:md|ipynb))", text):
            assert (path.parent / link).resolve().is_file(), f"{path.name}: {link}"


def test_a_page_has_text_code_and_outputs_of_its_notebook():
    pytest.importorskip("mkdocs")
    pages = tool("notebook_pages")
    notebook = json.loads((GALLERY / "aerial-pair.ipynb").read_text(encoding="utf-8"))
    page = pages.page_of(notebook, "aerial-pair.ipynb")
    assert page.startswith("# A bundle of an aerial pair\n")
    assert '<a href="aerial-pair.ipynb" download>' in page
    assert "```python\nimport numpy as np" in page
    assert "62_15 X0 [m]               3708.694        3708.69352" in page
    assert "<div>" in page or "data:image/png" in page


def test_the_site_holds_the_notebooks(tmp_path):
    pytest.importorskip("mkdocs")
    site = tmp_path / "site"
    subprocess.run(
        [sys.executable, "-m", "mkdocs", "build", "--strict", "--quiet", "--site-dir", str(site)], cwd=ROOT, check=True
    )
    found = json.loads((site / "search/search_index.json").read_text(encoding="utf-8"))["docs"]
    locations = {d["location"] for d in found}
    for path in NOTEBOOKS:
        assert f"gallery/{path.stem}/" in locations
        assert (site / f"gallery/{path.stem}" / path.name).is_file()
        assert f'href="{path.stem}/"' in (site / "gallery/index.html").read_text(encoding="utf-8")
