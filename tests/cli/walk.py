"""All commands of the command line, groups opened."""

import click

from raybundle.cli.main import cli


def commands(group=cli, words=()):
    """The words of each command, and the command."""
    context = click.Context(group)
    for name in group.list_commands(context):
        command = group.get_command(context, name)
        if isinstance(command, click.Group):
            yield from commands(command, (*words, name))
        else:
            yield (*words, name), command
