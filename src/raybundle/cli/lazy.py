"""Groups of commands whose members are loaded when they are called."""

from __future__ import annotations

from collections.abc import Mapping
from importlib import import_module

import click

from raybundle.cli.command import Group


class LazyGroup(Group):
    """A group whose subcommand NAME is the object `command` of the module NAME in `home`, its dashes as underscores."""

    home: str = ""
    told: Mapping[str, str]
    """What each does, by name, in the order in which they are used"""

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Names in the order in which they are used."""
        del ctx
        return list(self.told)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """Load one subcommand."""
        del ctx
        name = cmd_name.replace("-", "_")
        return import_module(f"{self.home}.{name}").command if cmd_name in self.told else None

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """List the subcommands without loading them."""
        del ctx
        with formatter.section("Commands"):
            formatter.write_dl(list(self.told.items()))
