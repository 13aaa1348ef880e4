"""Every example of the documentation runs: python blocks and command lines of a page in one session.

A command line may begin with environment variables; a line `# prints: TEXT` after it says what its output holds.
"""

import itertools
import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

import click
import pytest

from raybundle.cli.main import cli

DOCS = Path(__file__).resolve().parents[2] / "docs"
FENCE = re.compile(r"^```(python|console)\n(.*?)^```", re.MULTILINE | re.DOTALL)
RUN = """
import os, subprocess, sys


def run(words, variables):
    done = subprocess.run(
        [sys.executable, "-m", *words], env={**os.environ, **variables}, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, (words, done.stderr)
    return done.stdout + done.stderr
"""
PAGES = [
    p
    for p in sorted(DOCS.rglob("*.md"))
    if FENCE.search(p.read_text()) and "reference" not in p.relative_to(DOCS).parts
]


LONG = {
    "calibrate", "exchange", "line-scanner", "measure-by-hand", "next-photograph", "own-observation-kind",
    "photograph-lists", "plan-a-facade", "plan-a-flight", "plan-photographs", "rectify",
    "results-in-python", "satellite-pair", "satellite-rpc", "targets", "video", "without-a-compiler",
}  # fmt: skip
"""Pages whose examples take more than five seconds"""
RUN_PAGES = [pytest.param(p, marks=pytest.mark.long if p.stem in LONG else (), id=p.stem) for p in PAGES]


@pytest.mark.parametrize("page", RUN_PAGES)
def test_page(page, tmp_path):
    script = [RUN]
    for kind, text in FENCE.findall(page.read_text()):
        if kind == "python":
            script.append(text)
        else:
            for line in text.strip().splitlines():
                if line.startswith("# prints: "):
                    script.append(f"assert {line.removeprefix('# prints: ')!r} in printed, printed")
                    continue
                words = shlex.split(line)
                program = words.index("raybundle")
                assert all(re.fullmatch(r"[A-Z_]+=\S*", w) for w in words[:program]), line
                variables = dict(w.split("=", 1) for w in words[:program])
                script.append(f"printed = run({words[program:]!r}, {variables!r})")
    file = tmp_path / "page.py"
    file.write_text("\n".join(script))
    done = subprocess.run(
        [sys.executable, "-W", "error", str(file)], cwd=tmp_path, capture_output=True, text=True, check=False,
        env=os.environ,
    )  # fmt: skip
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-3000:]


COMMAND = re.compile(r"^(?:    |\\$ )(raybundle [a-z].*)$", re.MULTILINE)
SHOWN = [
    (page.stem, line)
    for page in sorted(DOCS.rglob("*.md"))
    if "reference" not in page.relative_to(DOCS).parts
    for line in COMMAND.findall(page.read_text())
]


@pytest.mark.parametrize(("page", "line"), SHOWN, ids=[f"{p}-{k}" for k, (p, _) in enumerate(SHOWN)])
def test_commands_that_are_shown_have_their_options(page, line):
    """Lines that are not run, for want of photographs, are at least understood: no option that there is not."""
    words = shlex.split(line.split(" #")[0].replace("...", ""))[1:]
    words = list(itertools.takewhile(lambda w: w not in {"|", ">", "&&"}, words))
    group, context = cli, click.Context(cli, info_name="raybundle")
    while isinstance(group, click.Group):
        name = words.pop(0)
        found = group.get_command(context, name)
        assert found is not None, f"{page}: {line}"
        group, context = found, click.Context(found, info_name=name, parent=context)
    try:
        _, rest, _ = group.make_parser(context).parse_args(words)
    except click.UsageError as error:
        pytest.fail(f"{page}: {line}: {error.format_message()}")
    assert not [w for w in rest if w.startswith("--")], line


def options_of_commands(command, context, name=""):
    """Every command by its words, with the options that it has."""
    if not isinstance(command, click.Group):
        return {name: {o for p in command.params for o in (*p.opts, *p.secondary_opts)} | {"--help", "--version"}}
    found = {}
    for word in command.list_commands(context):
        inner = command.get_command(context, word)
        below = click.Context(inner, info_name=word, parent=context)
        found |= options_of_commands(inner, below, f"{name} {word}".strip())
    return found


FOREIGN = {"--no-deps"}
"""Options of other programs, as of pip."""


@pytest.mark.parametrize("page", [*sorted(DOCS.rglob("*.md")), DOCS.parent / "README.md"], ids=lambda p: p.stem)
def test_options_that_are_named_within_a_sentence_exist(page):
    known = options_of_commands(cli, click.Context(cli, info_name="raybundle"))
    every = set().union(*known.values()) | FOREIGN
    text = re.sub(r"^```.*?^```", "", page.read_text(), flags=re.MULTILINE | re.DOTALL)
    for code in (" ".join(c.split()) for c in re.findall(r"`([^`]+)`", text)):
        options = set(re.findall(r"(?<![\w-])--[a-z][a-z-]*", code))
        assert options <= every, code
        if code.startswith("raybundle "):
            words = code.split()[1:]
            own = known.get(" ".join(words[:2]), known.get(words[0]))
            assert own is None or options <= own, code


def test_every_page_is_in_the_navigation():
    nav = (DOCS.parent / "mkdocs.yml").read_text()
    for page in DOCS.rglob("*.md"):
        assert str(page.relative_to(DOCS)) in nav


def test_every_page_of_the_navigation_is_reached_from_the_index():
    """By links alone, as who reads in a folder or on a page of a forge has no navigation."""
    nav = re.findall(r": (\S+\.md)$", (DOCS.parent / "mkdocs.yml").read_text(), re.MULTILINE)
    assert len(nav) > 80
    reached, further = set(), ["index.md"]
    while further:
        page = further.pop()
        if page in reached:
            continue
        reached.add(page)
        for link in re.findall(r"\]\(([^)#\s]+\.md)(?:#[^)]*)?\)", (DOCS / page).read_text()):
            target = (DOCS / page).parent.joinpath(link).resolve()
            assert target.is_file(), f"{page}: {link}"
            if target.is_relative_to(DOCS):
                further.append(str(target.relative_to(DOCS)))
    assert sorted(set(nav) - reached) == []
    linked = re.findall(r"\]\(([^)#\s]+\.md)", (DOCS / "index.md").read_text())
    told = [p for p in nav if p.split("/")[0] in {"tutorial", "how-to", "explanation"}]
    assert sorted(set(told) - set(linked)) == []


def test_the_readme_shows_the_two_commands():
    readme = (DOCS.parent / "README.md").read_text()
    assert "make demo" in readme
    assert "make test" in readme


def test_the_page_of_benchmarks_lists_every_script():
    page = (DOCS / "explanation/benchmarks.md").read_text()
    for script in (DOCS.parent / "benchmarks").glob("*.py"):
        assert f"`benchmarks/{script.name}`" in page


def test_every_command_shows_an_example():
    """Also those of groups; `datasets` and the like are examples themselves."""
    page = (DOCS / "reference/command-line.md").read_text()
    groups = {
        "rpc": ("fit", "correct", "project", "info"),
        "targets": ("sheet", "choose", "detect"),
        "calibration": ("add", "convert", "compare", "find", "list"),
    }
    for words in (f"{group} {name}" for group, names in groups.items() for name in names):
        text = page.partition(f"### raybundle {words}\n")[2].partition("\n#")[0]
        assert "Example:" in text, words
