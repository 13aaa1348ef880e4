"""`raybundle explain`."""

from __future__ import annotations

import difflib
import json

import click

from raybundle import words
from raybundle.cli.common import Command
from raybundle.errors import InputError
from raybundle.words import Reader

CLOSE = 3
"""Codes that are proposed for one that there is not"""


@click.command("explain", cls=Command)
@click.argument("code")
@click.option("--language", default=words.ENGLISH, show_default=True, metavar="CODE", help="Language: en, de, fr.")
@click.option("--json", "as_json", is_flag=True, help="Print JSON.")
def command(code: str, language: str, as_json: bool) -> None:  # noqa: FBT001  (click's signature)
    """Explain a message by the code in its square brackets, or all messages of a subject.

    \b
    Example:
      raybundle explain outline.no_area
    """
    code = code.strip("[]")
    found = [c for c in words.codes() if c == code] or [c for c in words.codes() if c.startswith(f"{code}.")]
    if language not in words.languages():
        raise InputError("message.unknown_language", language=language, known=list(words.languages()))
    if not found:
        raise InputError(
            "message.unknown_code", code_name=code, close=difflib.get_close_matches(code, words.codes(), CLOSE, 0.5)
        )
    reader = Reader(language, flags=True)
    parts = [explained(c, reader) for c in found]
    if as_json:
        click.echo(json.dumps(parts, ensure_ascii=False, indent=1))
        return
    for part in parts:
        click.echo(f"{part['code']}: {part['example']}")
        for line in (part["why"], part["do"]):
            if line:
                click.echo(f"  {line}")


def explained(code: str, reader: Reader) -> dict[str, str]:
    """A message with the values of its example, why it matters and what to do."""
    values = words.examples(code)
    return {
        "code": code, "example": words.headline(code, values, reader), "why": words.why(code, values, reader),
        "do": words.action(code, values, reader),
    }  # fmt: skip
