"""`raybundle status`."""

from __future__ import annotations

from pathlib import Path

import click

from raybundle.cli.common import FOLDER, Command, facts


@click.command("status", cls=Command)
@click.argument("project", type=FOLDER)
def command(project: Path) -> None:
    """Show the stages of a project folder or of a calibration: what the last run made, what came from the cache.

    \b
    Example:
      raybundle status facade-project
    """  # noqa: D301
    from raybundle.pipeline.project import Project  # noqa: PLC0415
    from raybundle.results.folder import PROJECT  # noqa: PLC0415

    of_calibration = (project / PROJECT / "project.db").is_file()
    opened = Project.open(project / PROJECT if of_calibration else project, create=False)
    try:
        records = {r.name: r for r in opened.stages()}
    finally:
        opened.close()
    facts(stages={n: records.get(n) for n in _stages(of_calibration=of_calibration)})
    click.echo(f" {'stage':12s} {'seconds':>8s} {'CPU s':>8s} {'memory':>8s}  finished")
    for name in _stages(of_calibration=of_calibration):
        r = records.get(name)
        if r is None:
            click.echo(f" {name:12s} {'-':>8s} {'-':>8s} {'-':>8s}  not done")
            continue
        source = "from cache" if r.from_cache else r.finished.replace("T", " ").rstrip("Z")
        figures = f"{r.seconds:8.1f} {r.cpu_seconds:8.1f} {r.peak_memory_mb:6.0f}MB"
        click.echo(f" {name:12s} {figures}  {source}  {r.summary}".rstrip())


def _stages(*, of_calibration: bool) -> tuple[str, ...]:
    """What the stages are called, in order."""
    if of_calibration:
        from raybundle.workflows.calibrating import CALIBRATE  # noqa: PLC0415

        return CALIBRATE.titles()
    from raybundle.workflows.orient import stages  # noqa: PLC0415

    return stages()
