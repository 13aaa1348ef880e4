"""What a command reports with --json: its messages by code, and those of an error."""

import json

from raybundle.cli.main import main

PARTS = ("summary", "details", "faults", "warnings", "notes")


def reported(capsys, *arguments, status=0):
    """The JSON object that a command prints; without arguments: that the last one has printed."""
    if arguments:
        capsys.readouterr()
        assert main([*map(str, arguments), "--json"]) == status
    return json.loads(capsys.readouterr().out.splitlines()[-1])


def values_of(found, parts=PARTS):
    """Values of each reported message by its code; of several with one code those of the last."""
    return {m["code"]: m["values"] for part in parts for m in found.get(part, ())}


def refusal(capsys, *arguments, status=2):
    """Code and values of the error with which a command ends."""
    found = reported(capsys, *arguments, status=status)
    return found["code"], found["values"]


def codes_of(found, parts=PARTS):
    """Codes of the reported messages, in their order."""
    return [m["code"] for part in parts for m in found.get(part, ())]


def texts_of(found, parts=PARTS):
    """Their texts: of what has no code of its own."""
    return "\n".join(m["text"] for part in parts for m in found.get(part, ()))
