"""Every example of the documentation runs: python blocks and command lines of a page in one session.

A command line may begin with environment variables; a line `# prints: TEXT` after it says what its output holds,
`# exits: N` the exit status, where it is not 0.  `raybundle studio` is begun, shows its page and is ended.  A line
`# not run: REASON` stands on the page below a command that only who has what it needs can run; such commands are few,
and counted.  Each line `<!-- test -->` stands for the next part (`# %%`) of tests/docs/pages/PAGE.py, which prepares
or verifies what readers see.  What a page takes for granted is made by `samples`.
"""

import itertools
import json
import os
import re
import shlex
import subprocess
import sys
import tomllib
from pathlib import Path

import click
import pytest

from raybundle.cli.main import cli
from tests.docs.samples import TEST, lay_out, with_tests

DOCS = Path(__file__).resolve().parents[2] / "docs"
README = DOCS.parent / "README.md"
FENCE = re.compile(r"^```(python|console)\n(.*?)^```", re.MULTILINE | re.DOTALL)
SAMPLE = re.compile(r"^<!-- tried with: (.*) -->$", re.MULTILINE)
NOT_RUN = "# not run: "
RUN = """
import atexit, os, re, subprocess, sys, urllib.request


def run(words, variables, exits):
    done = subprocess.run(
        [sys.executable, "-m", *words], env={**os.environ, **variables}, capture_output=True, text=True, check=False
    )
    assert done.returncode == exits, (words, done.stdout, done.stderr)
    return done.stdout + done.stderr


def serve(words, variables, exits):
    # what runs until its reader ends it: it shows its page, and is ended
    begun = subprocess.Popen(
        [sys.executable, "-u", "-m", *words, "--no-browser"], env={**os.environ, **variables}, text=True,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
    )
    printed = ""
    try:
        while not (address := re.search("http://\\\\S+", printed)):
            line = begun.stdout.readline()
            assert line, printed
            printed += line
        opener = urllib.request.build_opener(urllib.request.HTTPCookieProcessor())
        with opener.open(address[0]) as answer:
            assert b"studio.js" in answer.read()
    finally:
        begun.terminate()
        begun.communicate()
    return printed


def keep(words, variables, exits):
    # what works for others until it is ended, which is at the end of the page; it says when it is ready
    begun = subprocess.Popen(
        [sys.executable, "-u", "-m", *words], env={**os.environ, **variables}, text=True,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
    )
    atexit.register(lambda: (begun.terminate(), begun.communicate()))
    printed = begun.stdout.readline()
    assert begun.poll() is None, printed
    return printed


def shell(command):
    done = subprocess.run(["bash", "-euc", command], capture_output=True, text=True, check=False)
    assert done.returncode == 0, (command, done.stdout, done.stderr)
    return done.stdout + done.stderr
"""
PAGES = [
    p
    for p in [*sorted(DOCS.rglob("*.md")), README]
    if (FENCE.search(text := p.read_text()) or TEST in text) and "reference" not in p.relative_to(DOCS.parent).parts
]


LONG = {
    "README", "a-camera-for-vision", "a-facade", "a-flight", "a-satellite-scene", "accuracy-class", "buckets",
    "calibrate",
    "calibration-report", "calibrations-elsewhere", "cluster", "detect-targets", "drawing-sheet", "epochs", "exchange",
    "facade", "first-photographs", "gis-and-cad", "gnss-ins", "gnss-ins-in-python", "heights", "install",
    "large-blocks", "line-scanner", "masks", "measure-a-part", "measure-by-hand", "measure-from-nothing",
    "measure-targets", "merge-blocks",
    "moved", "next-photograph", "orthorectify", "own-observation-kind", "own-unknowns", "photograph-lists",
    "plan-a-facade", "plan-a-flight", "plan-photographs", "predict-a-flight", "read-the-report", "recipes",
    "recording-sheet", "rectify", "results-in-python", "rtk-flight", "satellite-pair", "satellite-rpc",
    "scale-bars", "strain", "studio", "surface", "surface-products", "surface-test", "targets", "uav", "uav-precision",
    "video", "volumes-over-time", "without-a-compiler",
}  # fmt: skip
"""Pages whose examples take more than five seconds; others of more than 1.5 stand in tests/slow.txt"""
RUN_PAGES = [pytest.param(p, marks=pytest.mark.long if p.stem in LONG else (), id=p.stem) for p in PAGES]


def lines_of(text):
    """Lines of a console block with what follows each: a command, and what is said of it."""
    return list(itertools.pairwise([*text.strip().splitlines(), ""]))


def commands_of(text):
    """Each command of a console block, and why it is not run; None where it is."""
    return [
        (line, after.removeprefix(NOT_RUN) if after.startswith(NOT_RUN) else None)
        for line, after in lines_of(text)
        if line and not line.startswith("# ")
    ]


def steps(text):
    """The Python that runs a console block."""
    for line, after in lines_of(text):
        if line.startswith("# prints: "):
            yield f"assert {line.removeprefix('# prints: ')!r} in printed, printed"
        if not line or line.startswith("# ") or after.startswith(NOT_RUN):
            continue
        exits = int(after.removeprefix("# exits: ")) if after.startswith("# exits: ") else 0
        words = shlex.split(line)
        begin = next((k for k, w in enumerate(words) if not re.fullmatch(r"[A-Z_]+=\S*", w)), 0)
        if words[begin] != "raybundle" or {"|", ">"} & set(words):
            yield f"printed = shell({line!r})"
            continue
        variables = dict(w.split("=", 1) for w in words[:begin])
        name = "".join(words[begin + 1 : begin + 2])
        works_for_others = name == "scheduler" or (name == "worker" and "--cluster" in words)
        how = "serve" if name == "studio" else "keep" if works_for_others else "run"
        yield f"printed = {how}({words[begin:]!r}, {variables!r}, {exits})"


@pytest.fixture(scope="session")
def shared(tmp_path_factory):
    """A folder that the processes of one run of the tests have in common."""
    base = tmp_path_factory.getbasetemp()
    return base.parent if "PYTEST_XDIST_WORKER" in os.environ else base


@pytest.mark.parametrize("page", RUN_PAGES)
def test_page(page, tmp_path, shared):
    text = with_tests(page)
    for name in (n.strip() for found in SAMPLE.findall(text) for n in found.split(",")):
        lay_out(name, shared, tmp_path)
    script = [RUN]
    for kind, block in FENCE.findall(text):
        script += [block] if kind == "python" else steps(block)
    (tmp_path / "demo_data").symlink_to(DOCS.parent / "demo_data")
    file = tmp_path / "page.py"
    file.write_text("\n".join(script))
    # programs of this environment come first, as in one that is activated
    path = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
    done = subprocess.run(
        [sys.executable, "-W", "error", str(file)], cwd=tmp_path, capture_output=True, text=True, check=False,
        env={**os.environ, "PATH": path},
    )  # fmt: skip
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-3000:]


SHOWN = [
    (page.stem, line, why)
    for page in PAGES
    for kind, block in FENCE.findall(page.read_text())
    if kind == "console"
    for line, why in commands_of(block)
]
UNTRIED = 8
"""Commands of the pages that no test runs.  It may fall."""


def test_commands_that_no_test_runs_are_few_and_say_why():
    untried = [(page, line, why) for page, line, why in SHOWN if why is not None]
    assert all(len(why) > 10 for _, _, why in untried)
    assert len(untried) <= UNTRIED, untried
    assert len([line for _, line, _ in SHOWN if line.startswith("raybundle ")]) > 190


@pytest.mark.parametrize("page", [*sorted(DOCS.rglob("*.md")), README], ids=lambda p: p.stem)
def test_a_command_stands_in_a_block_that_is_run(page):
    """In no indented paragraph and in no block of another kind, where nothing would run it."""
    if "reference" in page.parts:
        return  # made from the help, whose examples are those of the command
    text = re.sub(r"^```(?:python|console)\n.*?^```", "", page.read_text(), flags=re.MULTILINE | re.DOTALL)
    assert re.findall(r"^(?: {4}|\$ )?(?:\.venv/bin/)?raybundle [a-z]+ .*$", text, re.MULTILINE) == []


@pytest.mark.parametrize(
    ("page", "line"),
    [(page, line) for page, line, why in SHOWN if why is not None],
    ids=[f"{p}-{k}" for k, (p, _, why) in enumerate(SHOWN) if why is not None],
)
def test_commands_that_are_not_run_have_their_options(page, line):
    """At least understood: no option that there is not."""
    if not line.startswith("raybundle "):
        return
    words = shlex.split(line.split(" #")[0])[1:]
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
        own = {o for p in command.params for o in (*p.opts, *p.secondary_opts)}
        return {name: own | {"--help", "--help-all", "--version"}}
    found = {}
    for word in command.list_commands(context):
        inner = command.get_command(context, word)
        below = click.Context(inner, info_name=word, parent=context)
        found |= options_of_commands(inner, below, f"{name} {word}".strip())
    return found


FOREIGN = {
    "--memory-limit",
    "--resources",
    "--preload",
    "--nthreads",
    "--no-deps",
    "--no-compile",
    "--dest",
    "--no-index",
    "--find-links",
}
"""Options of other programs, as of pip and Dask."""


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
    nav = re.findall(r": (\S+\.(?:md|ipynb))$", (DOCS.parent / "mkdocs.yml").read_text(), re.MULTILINE)
    assert len(nav) > 80
    reached, further = set(), ["index.md"]
    while further:
        page = further.pop()
        if page in reached:
            continue
        reached.add(page)
        for link in re.findall(r"\]\(([^)#\s]+\.(?:md|ipynb))(?:#[^)]*)?\)", (DOCS / page).read_text()):
            target = (DOCS / page).parent.joinpath(link).resolve()
            assert target.is_file(), f"{page}: {link}"
            if target.is_relative_to(DOCS):
                further.append(str(target.relative_to(DOCS)))
    assert sorted(set(nav) - reached) == []
    linked = re.findall(r"\]\(([^)#\s]+\.md)", (DOCS / "index.md").read_text())
    told = [p for p in nav if p.split("/")[0] in {"tutorial", "how-to", "explanation"}]
    assert sorted(set(told) - set(linked)) == []


def test_a_file_of_tests_has_its_page():
    files = {p.stem for p in (DOCS.parent / "tests/docs/pages").glob("*.py")}
    assert files == {p.stem for p in PAGES if TEST in p.read_text()}


def test_the_index_shows_every_command_and_links_a_page_beside_it():
    text = (DOCS / "index.md").read_text()
    rows = [row for row in text.splitlines() if row.startswith("| `raybundle ")]
    named = {name for row in rows for name in re.findall(r"`raybundle ([\w-]+)`", row)}
    assert named == set(cli.list_commands(click.Context(cli)))
    assert [row for row in rows if "](" not in row] == []
    plans = next(row for row in rows if "`raybundle plan`" in row)
    group = cli.get_command(click.Context(cli), "plan")
    assert all(f"`{name}`" in plans for name in group.list_commands(click.Context(group)))


@pytest.mark.long
def test_the_site_can_be_searched_and_needs_no_other_server(tmp_path):
    """Index and program of the search lie beside the pages; each page is in the index; no page loads from elsewhere."""
    words = [sys.executable, "-m", "mkdocs", "build", "--strict", "--quiet", "--site-dir", str(tmp_path / "site")]
    pytest.importorskip("mkdocs")
    subprocess.run(words, cwd=DOCS.parent, check=True)
    site = tmp_path / "site"
    found = json.loads((site / "search/search_index.json").read_text())["docs"]
    pages = {row["location"].partition("#")[0] for row in found}
    nav = re.findall(r": (\S+\.(?:md|ipynb))$", (DOCS.parent / "mkdocs.yml").read_text(), re.MULTILINE)
    assert len(pages) == len(nav)
    assert any("completion" in row["text"] for row in found if row["location"].startswith("how-to/install"))
    assert (site / "search/lunr.js").is_file()
    page = (site / "how-to/install/index.html").read_text()
    assert 'role="search"' in page
    for html in site.rglob("*.html"):
        loaded = re.findall(r"<(?:script|img|iframe)[^>]+src=[\"'](https?:)?//", html.read_text())
        styles = re.findall(r"<link[^>]+stylesheet[^>]+href=[\"'](?:https?:)?//", html.read_text())
        assert loaded + styles == [], html


def test_the_page_of_installing_names_every_extra_and_its_size():
    text = (DOCS / "how-to/install.md").read_text()
    extras = tomllib.loads((DOCS.parent / "pyproject.toml").read_text())["project"]["optional-dependencies"]
    rows = dict(re.findall(r"^\| `(\w+)` \|.*\| ([\d ]+)[^|]*\|$", text, re.MULTILINE))
    assert set(rows) == set(extras)


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
        "rpc": ("fit", "correct", "batch", "ortho", "project", "info"),
        "targets": ("sheet", "choose", "detect"),
        "calibration": ("add", "convert", "compare", "find", "list"),
    }
    for words in (f"{group} {name}" for group, names in groups.items() for name in names):
        text = page.partition(f"### raybundle {words}\n")[2].partition("\n#")[0]
        assert "Example:" in text, words
