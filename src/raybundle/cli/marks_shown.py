"""What was measured by hand, as the command line shows it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from raybundle.cli.common import counted

if TYPE_CHECKING:
    from raybundle.measuring.state import Axes, State


def shown(state: State) -> list[str]:
    """The lines of `raybundle mark list`."""
    lines = [f" {counted(len(state.marks), 'mark')} of {counted(len(state.points), 'point')}"]
    for name, p in state.points.items():
        places = state.marks_of(name)
        given = " ".join("-" if v is None else f"{v:g}" for v in p.xyz) if p.role != "tie" else ""
        lines.append(f"   {name}: {p.role} {given}".rstrip())
        for image, m in places.items():
            sx, sy = m.covariance[0] ** 0.5, m.covariance[1] ** 0.5
            lines.append(f"     {image}: {m.x_px:.2f} {m.y_px:.2f} px, sigma {sx:.2f} {sy:.2f} px, {m.how}")
    lines += [f" scale bar {a} - {b}: {v.length:g} +- {v.sigma:g}" for (a, b), v in state.bars.items()]
    lines += [f" {v.called} {n}: {', '.join(v.points)}" for n, v in state.lines.items()]
    if state.datum is not None:
        lines.append(f" coordinate system: {', '.join(state.datum.points)} ({_axes(state.datum)})")
    lines += [
        f" fiducial mark {n} in {i}: {m.x_px:.2f} {m.y_px:.2f} px, {m.how}" for (i, n), m in state.fiducials.items()
    ]
    lines += [f" rejected: {p} in {i}" for i, p in sorted(state.rejected)]
    lines += [f" parameter {s} of camera {c}: {choice}" for (c, s), choice in sorted(state.parameters.items())]
    for name, m in state.masks.items():
        where = f"all photographs of the camera of {m.image}" if m.camera else m.image
        lines.append(f" mask {name}: {counted(len(m.polygon), 'corner')}, in {where}")
    for name, d in state.drawings.items():
        lines.append(f" {d.kind} {name}: {counted(len(d.corners), 'corner')}, layer {d.layer}, on {d.surface}")
    return lines


def _axes(datum: Axes) -> str:
    return "origin, axis, plane" if datum.plane else "origin, axis; levels and plumb lines give the vertical"
