"""Observed rotations of images: inertial measurement units with their misalignment."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np

from raybundle.errors import InputError, message
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.deviations import correlated_after
from raybundle.numerics.records import Stuck, stuck_together
from raybundle.numerics.rotation import angle_derivatives, angles_from_rotation, rotation_from_angles
from raybundle.numerics.transform import SimilarityTransform
from raybundle.observations.correlation import correlated
from raybundle.observations.kind import Named, ObservationKind, Observed, Rows, Scope, Values, partials
from raybundle.observations.table import Table, Wrong, again, cells
from raybundle.platforms.imu import reported

STEEP = 0.01
"""Cosine of phi below which omega and kappa cannot be observed one by one."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Attitudes(Table):
    """Observed rotations of images (INS)."""

    name: ClassVar[str] = "attitudes"
    named_by: ClassVar[tuple[str, ...]] = ("image",)
    observed: ClassVar[str] = "angles"

    image: Index = cells("image", "image")
    angles: Array = cells("number", "omega_deg", "phi_deg", "kappa_deg", unit="deg", follows="stays")
    """(k, 3) omega, phi, kappa [rad] as the IMU shows them."""
    sigma: Array = cells(
        "number", "somega_deg", "sphi_deg", "skappa_deg", unit="deg", follows="stays", empty=True, limit="> 0"
    )
    """(k, 3) [rad]; NaN where an angle was not observed."""
    correlation: Array | None = cells(
        "number",
        "romega_phi",
        "romega_kappa",
        "rphi_kappa",
        follows="stays",
        deviations="sigma",
        empty=True,
        optional=True,
        fill=0.0,
    )
    """(k, 3) coefficients of correlation of the observed angles; None: independent."""
    imu: Index | None = cells("instrument", "imu", model="imu", empty=True, optional=True)
    """(k,) position in `Block.instruments` of the IMU with its misalignment, -1 or None: the image's own rotation."""

    def stuck(self, by: SimilarityTransform) -> Sequence[Stuck]:
        if not by.turns:
            return []
        angles, J = self._turned(by)
        steep = ~(np.cos(angles[:, 1]) > STEEP) & np.isfinite(angles[:, 1])
        return [
            Stuck(steep, message("transform.phi_near_right_angle")),
            *stuck_together(J, self.sigma, self.correlation, noun="angle"),
        ]

    def followed(self, by: SimilarityTransform) -> Attitudes:
        """Angles of the same rotation from the axes after."""
        if not by.turns:
            return self
        angles, J = self._turned(by)
        sigma, correlation = correlated_after(J, self.sigma, self.correlation)
        return replace(self, angles=angles, sigma=sigma, correlation=correlation)

    def _turned(self, by: SimilarityTransform) -> tuple[Array, Array]:
        """Angles (k, 3) after, and how small changes of them follow from those of the angles before (k, 3, 3)."""
        old = rotation_from_angles(self.angles)
        new = by.rotations(old)
        found = np.broadcast_to(np.eye(3), old.shape).copy()
        good = np.isfinite(old).all(axis=(1, 2))
        good &= (np.hypot(old[:, 0, 0], old[:, 1, 0]) > STEEP) & (np.hypot(new[:, 0, 0], new[:, 1, 0]) > STEEP)
        # a small rotation about the image's own axes is the same in both frames
        found[good] = angle_derivatives(new[good]) @ np.linalg.inv(angle_derivatives(old[good]))
        return angles_from_rotation(new), found

    def wrong(self) -> Sequence[Wrong]:
        blind: Mask = np.asarray(np.isnan(self.sigma).all(axis=1), bool)
        return [
            Wrong(again(self.image), "image", lambda _: message("observation.image_twice")),
            Wrong(blind, "somega_deg", lambda _: message("observation.no_sigma")),
        ]


class Attitude(ObservationKind):
    """v = omega, phi, kappa of exp(-[b]x) R - those observed, see `raybundle.platforms.imu`; of R without an IMU."""

    name = "attitude"
    group = "attitudes"
    order = 3
    title = "Observed attitudes"
    object = "image"
    noun = "observed attitude"
    quantities = "angles of attitudes"
    unit = "angle"
    table = Attitudes
    carries_datum = True
    left_open = "datum.misalignment_unknown"
    hides = (3, 4, 5)

    def check(self, table: Attitudes, scope: Scope) -> None:
        for k in np.flatnonzero(np.cos(table.angles[:, 1]) < STEEP)[:1]:
            raise InputError(
                "attitude.phi_right_angle",
                image=scope.image_ids[table.image[k]],
                phi_deg=np.degrees(table.angles[k, 1]),
            )

    def instruments(self, table: Attitudes, scope: Scope) -> set[int]:
        return set() if table.imu is None else {a for a in table.imu[scope.images[table.image]].tolist() if a >= 0}

    def rows(self, table: Attitudes, scope: Scope) -> Rows:
        whole = scope.images[table.image] & np.isfinite(table.angles).all(axis=1)
        item, axis = np.nonzero(whole[:, None] & (table.sigma > 0))
        return correlated(table, Rows.of(item, axis, table.angles[item, axis], table.sigma[item, axis]))

    def observed(self, table: Attitudes, rows: Rows, scope: Scope, values: Values) -> Observed:
        item, axis = rows.item, rows.component
        image = table.image[item]
        at = np.full(len(rows), -1, np.int32) if table.imu is None else scope.parameters_of(table.imu[item])
        residual, found = np.zeros(len(rows)), []
        for r in np.unique(at):
            k = np.flatnonzero(at == r)
            seen, turn, by = reported(values.rotation[image[k]], np.zeros(3) if r < 0 else values.interior[r, :3])
            D = angle_derivatives(seen)[np.arange(len(k)), axis[k]]
            difference = angles_from_rotation(seen)[np.arange(len(k)), axis[k]] - rows.value[k]
            residual[k] = np.arctan2(np.sin(difference), np.cos(difference))
            by_rotation, by_misalignment = D @ turn, D @ by
            found += [partials("rotation", k, image[k], j, by_rotation[:, j]) for j in range(3)]
            if r >= 0:
                found += [partials("interior", k, np.full(len(k), r), j, by_misalignment[:, j]) for j in range(3)]
        return Observed(residual, tuple(found))

    def named(self, table: Attitudes, rows: Rows, scope: Scope) -> Named:
        return Named(
            tuple(scope.image_ids[i] for i in table.image[rows.item].tolist()),
            tuple(("omega", "phi", "kappa")[a] for a in rows.component.tolist()),
        )
