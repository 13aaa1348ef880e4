"""Simulated networks of three dates: a field of points, of which some move; the truth beside it."""

from dataclasses import replace

import numpy as np

from raybundle.block.merge import merge_blocks
from raybundle.measuring.joint import Joint
from raybundle.metrology.congruence_model import model_of
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, brown_camera, field_scene
from raybundle.workflows.epochs.dated_points import Dates
from raybundle.workflows.epochs.stability import point_sets, stability

DAYS = ("2026-01-01", "2026-02-01", "2026-03-01")
CAMERA = brown_camera(estimate=("c", "x0", "y0", "K1"))
SCENE = field_scene(TargetField(camera=CAMERA, rows=6, columns=8, stations=6, frontal=2, seed=7))


def network(seed, moves=None):
    """The block of all dates and these; moves (3, points, 3) of each date."""
    blocks = []
    for d in range(len(DAYS)):
        scene = SCENE if moves is None else replace(SCENE, xyz=SCENE.xyz + moves[d])
        survey = Survey(
            seed=1000 * seed + d, image_sigma_px=0.3, orientation="exact", points="exact", interior="exact",
            least_rays=0,
        )  # fmt: skip
        b = simulate(scene, survey).observed
        blocks.append(replace(b, images=replace(b.images, ids=tuple(f"{i}-{d}" for i in b.images.ids))))
    block = merge_blocks(blocks, prefer={"point": 0, "camera": 0, "block": 0})
    return block, Dates.of([DAYS[int(i[-1])] for i in block.images.ids])


class Plan:
    """What is known of the network before anything moves: the power of its tests."""

    def __init__(self):
        block, dates = network(10_000)
        s = stability(block, dates)
        sets, C = point_sets(s.result, s.dated, s.tested, dates, Joint.of(s.result))
        self.ids, self.limit = s.congruence.ids, s.congruence.limit
        n = len(self.ids)
        C = C / s.result.variance_factor
        self.model = model_of(sets[0], sets[1:], np.ones(n, bool), scale=True, joint=C)
        self.xyz = sets[0].xyz

    def drawn(self, which, sizes, ways):
        """Displacements (2, n, 3) of so many standard deviations, and the power of the test of each point."""
        from scipy.special import chdtri, chndtr

        moved = np.zeros(len(self.ids), bool)
        moved[which] = True
        C = self.model.stayed(moved).compared()[1]
        found, power = np.zeros((2, len(self.ids), 3)), []
        for i, size, way in zip(which, sizes, ways, strict=True):
            v = way * size / np.sqrt(way.ravel() @ np.linalg.solve(C[i], way.ravel()))
            found[:, i] = v
            power.append(1 - float(chndtr(chdtri(6, self.limit), 6, size**2)))
        return found, np.array(power)

    def moves(self, found):
        """The same of all points of the scene and all dates."""
        moves = np.zeros((3, len(SCENE.xyz), 3))
        moves[1:, [int(i) - 1 for i in self.ids]] = found
        return moves
