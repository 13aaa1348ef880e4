"""Notebooks of docs/gallery as pages of the documentation: a hook of mkdocs (`hooks` in mkdocs.yml).

A notebook is a page with the outputs that are stored in it; nothing is run.  Its text goes through the same Markdown as
that of all pages, so that search, links and the check of links know it; a link at its head leads to the notebook.
"""

import html
import json
import shutil
from pathlib import Path
from typing import Any

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files
from mkdocs.structure.pages import Page

SUFFIX = ".ipynb"


class Notebook(File):
    """A page that is made from a notebook."""

    def is_documentation_page(self) -> bool:
        """As Markdown is."""
        return True


def on_files(files: Files, *, config: MkDocsConfig) -> Files:
    """Notebooks are pages, and what they import is none."""
    for file in list(files):
        if file.src_uri.endswith(SUFFIX):
            files.remove(file)
            files.append(Notebook(file.src_uri, file.src_dir, file.dest_dir, config.use_directory_urls))
    return files


def on_page_read_source(*, page: Page, config: MkDocsConfig) -> str | None:  # noqa: ARG001 (as mkdocs calls it)
    """The text of a notebook's page."""
    if not page.file.src_uri.endswith(SUFFIX):
        return None
    assert page.file.abs_src_path is not None
    return page_of(json.loads(Path(page.file.abs_src_path).read_text(encoding="utf-8")), Path(page.file.src_uri).name)


def on_post_build(*, config: MkDocsConfig) -> None:
    """The notebooks themselves, beside their pages."""
    for file in Path(config.docs_dir).rglob(f"*{SUFFIX}"):
        place = Path(config.site_dir) / file.relative_to(config.docs_dir).with_suffix("")
        shutil.copy(file, place / file.name)


def page_of(notebook: dict[str, Any], name: str) -> str:
    """Markdown of a notebook with its stored outputs."""
    parts: list[str] = []
    for cell in notebook["cells"]:
        source = "".join(cell["source"])
        if cell["cell_type"] == "markdown":
            parts.append(source)
        elif cell["cell_type"] == "code":
            parts += [f"```python\n{source}\n```", *map(_shown, cell["outputs"])]
    head, _, rest = "\n\n".join(p for p in parts if p).partition("\n")
    return f'{head}\n\n<a href="{name}" download>{name}</a>\n{rest}\n'


def _shown(output: dict[str, Any]) -> str:
    """A stored output: a figure, or text."""
    data = output.get("data", {})
    if "text/html" in data:
        return f"<div>{''.join(data['text/html'])}</div>"
    if "image/svg+xml" in data:
        return f"<div>{''.join(data['image/svg+xml'])}</div>"
    if "image/png" in data:
        told = html.escape("".join(data.get("text/plain", "figure")))
        return f'<img alt="{told}" src="data:image/png;base64,{"".join(data["image/png"]).strip()}">'
    text = "".join(output.get("text", data.get("text/plain", ""))).rstrip("\n")
    return f"```text\n{text}\n```" if text else ""
