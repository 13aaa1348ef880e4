"""What the report states of oriented photographs, taken from their orientation."""

from __future__ import annotations

from typing import TYPE_CHECKING

from raybundle.errors import phrase
from raybundle.report.facts import CameraFact, PairFact, PhotoFact, PhotographFacts, StageFact

if TYPE_CHECKING:
    from raybundle.io.photos.cameras import CameraGroup
    from raybundle.io.photos.photo import Photo
    from raybundle.workflows.orient import Orientation


def photograph_facts(done: Orientation) -> PhotographFacts:
    """The facts of a report's sections about photographs."""
    camera = {i: g.id for g in done.groups for i in g.photos}
    names = [p.name for p in done.photos]
    return PhotographFacts(
        photographs=tuple(_photo(p, camera[i]) for i, p in enumerate(done.photos)),
        cameras=tuple(_camera(g) for g in done.groups),
        refused=done.refused,
        not_oriented=done.not_oriented,
        pairs=tuple(
            PairFact(
                first=names[p.first],
                second=names[p.second],
                candidates=p.candidates,
                verified=len(p.matches),
                geometry=p.geometry,
            )
            for p in done.pairs
        ),
        stages=tuple(
            StageFact(
                name=s.name,
                seconds=s.seconds,
                cpu_seconds=s.cpu_seconds,
                peak_memory_mb=s.peak_memory_mb,
                from_cache=s.from_cache,
                summary=s.summary,
            )
            for s in done.stages
        ),
        sigma_px=done.sigma_px,
    )


def _photo(photo: Photo, camera: str) -> PhotoFact:
    about = photo.metadata
    position = ""
    if about.gps is not None:
        sigma = 0.0 if about.gps.sigma_m is None else float(max(about.gps.sigma_m))
        position = phrase("report_photographs.recorded_position", fix=about.gps.fix or "none", sigma_m=sigma)
    return PhotoFact(
        name=photo.name,
        camera=camera,
        width_px=photo.width_px,
        height_px=photo.height_px,
        taken="" if about.taken is None else about.taken.strftime("%Y-%m-%d %H:%M:%S"),
        device=" ".join(w for w in (about.make, about.model) if w),
        position=position,
    )


def _camera(group: CameraGroup) -> CameraFact:
    pixel = group.pixel_mm[0]
    return CameraFact(
        camera=group.id,
        name=group.name,
        photographs=len(group.photos),
        source=group.source,
        c_px=group.c_mm / pixel,
        sigma_c_px=group.sigma_c_mm / pixel,
        remarks=group.stated,
    )
