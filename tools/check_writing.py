"""Check the words that people read: messages of the catalogue, help, docstrings of the public API, README and docs.

    python tools/check_writing.py          the findings, file by file; exit status 1 where there are any
    python tools/check_writing.py --count  how many of each kind stand in the pages that are not checked yet

Checked: words for what programs do not do (they report, print, detect; they do not speak), sentences of more than 25
words, words for which docs/reference/glossary.toml has another term.  Quotations, code and formulas are not checked.
tools/unchecked_pages.txt lists the pages of docs/ that are not checked yet; it may only shrink.
"""

from __future__ import annotations

import argparse
import inspect
import re
import sys
import tomllib
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import click

import raybundle
from raybundle import words
from raybundle.cli.main import cli

ROOT = Path(__file__).resolve().parents[1]
LONGEST = 25
"""Words of a sentence"""
SPOKEN = re.compile(
    r"\b(told|tells?|said|says|unsaid|whose|what it is|what was|of what|none of these|as it is)\b", re.IGNORECASE
)
EXCEPTIONS = frozenset({"docs/reference/glossary.md"})
"""It lists the words to avoid"""
PAGES = frozenset((ROOT / "tools/unchecked_pages.txt").read_text(encoding="utf-8").split())
"""Pages of docs/ that are not checked yet"""
_CODE = re.compile(r"```.*?```|``[^`]*``|`[^`]*`|<!--.*?-->|\[\^?[^\]]*\]\([^)]*\)|^    .*?$", re.DOTALL | re.MULTILINE)
_END = re.compile(r"(?<=[.!?:;])[)\"']*\s+|\n\s*\n|\n\s*[-*] |\n\s*\d+\. ")


def sentences(text: str) -> Iterator[str]:
    """Sentences of a text in Markdown, without code, tables, headings and formulas."""
    text = re.sub(r"^(?:\||#|<p>).*$", "\n", text, flags=re.MULTILINE)
    plain = _CODE.sub(" X ", re.sub(r"\n    ", "\n", text) if "```" not in text and "\n\n    " not in text else text)
    for part in _END.split(plain):
        found = " ".join(part.split())
        if found:
            yield found


def findings(text: str, avoid: dict[re.Pattern[str], str]) -> Iterator[tuple[str, str]]:
    """Kind and sentence of everything that the rules object to."""
    for sentence in sentences(text):
        unquoted = re.sub(r"\"[^\"]*\"", "", sentence)
        if SPOKEN.search(unquoted):
            yield "word", sentence
        if len(re.findall(r"[^\W\d_][\w'-]*", sentence)) > LONGEST:
            yield "long", sentence
        for pattern, term in avoid.items():
            if pattern.search(unquoted):
                yield f"term ({term})", sentence


def glossary() -> dict[re.Pattern[str], str]:
    """Words to avoid, and the term in their place."""
    terms = tomllib.loads((ROOT / "docs/reference/glossary.toml").read_text(encoding="utf-8"))
    return {
        re.compile(rf"\b{re.escape(word)}s?\b", re.IGNORECASE): name
        for name, term in terms.items()
        for word in term.get("avoid", ())
    }


def catalogue() -> Iterator[tuple[str, str]]:
    """Every English message with its example values."""
    for code in words.codes():
        yield f"message {code}", words.sentences(code, words.examples(code), words.COMMAND_LINE)


def help_texts() -> Iterator[tuple[str, str]]:
    """Help of every command and option."""

    def walk(command: click.Command, name: str) -> Iterator[tuple[str, str]]:
        yield (
            f"help of {name}",
            re.sub(r"\x08\n.*?(\n\s*\n|$)", "\n\n", inspect.cleandoc(command.help or ""), flags=re.DOTALL),
        )
        for option in command.params:
            if isinstance(option, click.Option) and option.help:
                yield f"help of {name} {option.opts[-1]}", re.sub(r"\[default:.*?\]", "", option.help)
        if isinstance(command, click.Group):
            context = click.Context(command)
            for sub in command.list_commands(context):
                member = command.get_command(context, sub)
                if member is not None:
                    yield from walk(member, f"{name} {sub}")

    seen: set[str] = set()
    for where, text in walk(cli, "raybundle"):
        if text not in seen:
            seen.add(text)
            yield where, text


def docstrings() -> Iterator[tuple[str, str]]:
    """Docstrings of the public functions and classes: what stands before their lists of arguments."""
    for name in sorted(raybundle.__all__):
        thing = getattr(raybundle, name)
        text = inspect.getdoc(thing) if callable(thing) else None
        if text:
            yield f"docstring of {name}", re.sub(r"^\w[\w, *]*\s{2,}", "\n\n", text, flags=re.MULTILINE)


def pages() -> Iterator[tuple[str, str]]:
    """README and the pages of docs/."""
    for path in [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]:
        yield path.relative_to(ROOT).as_posix(), path.read_text(encoding="utf-8")


def main() -> None:
    """Print the findings."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--count", action="store_true")
    parser.add_argument("--kinds", nargs="*")
    given = parser.parse_args()
    avoid, wrong, open_ = glossary(), 0, Counter[str]()
    for source in (catalogue, help_texts, docstrings, pages):
        for where, text in source():
            found = list(findings(text, avoid))
            if where in EXCEPTIONS:
                continue
            if where in PAGES:
                open_[where] += len(found)
                if not found:
                    wrong += 1
                    print(f"{where}: nothing to object: take it off PAGES")
                continue
            for kind, sentence in found:
                if not given.kinds or any(kind.startswith(k) for k in given.kinds):
                    wrong += 1
                    print(f"{where}: {kind}: {sentence[:160]}")
    if given.count:
        for where, n in open_.most_common():
            print(f"{where}: {n}")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
