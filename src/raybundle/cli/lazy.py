"""Groups of commands whose members are loaded when they are called."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from importlib import import_module
from types import MappingProxyType

import click

from raybundle.cli.command import HELP_ALL, Group, more_line


class LazyGroup(Group):
    """A group whose subcommand NAME is the object `command` of the module NAME in `home`, its dashes as underscores."""

    home: str = ""
    summaries: Mapping[str, str]
    """What each does, by name, in the order in which they are used"""
    sections: Mapping[str, Mapping[str, str]] = MappingProxyType({})
    """The same by heading; without any, all stand under one"""
    frequent: Collection[str] = ()
    """Those that --help shows; without any, all"""

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Names in the order in which they are used."""
        del ctx
        return list(self.summaries)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """Load one subcommand."""
        del ctx
        name = cmd_name.replace("-", "_")
        return import_module(f"{self.home}.{name}").command if cmd_name in self.summaries else None

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """List the subcommands without loading them."""
        shown = self.summaries if ctx.meta.get(HELP_ALL) or not self.frequent else self.frequent
        width = max(map(len, shown))
        for heading, members in (self.sections or {"Commands": self.summaries}).items():
            rows = [(name.ljust(width), summary) for name, summary in members.items() if name in shown]
            if rows:
                with formatter.section(heading):
                    formatter.write_dl(rows)
        more_line(formatter, len(self.summaries) - len(shown), "command")
