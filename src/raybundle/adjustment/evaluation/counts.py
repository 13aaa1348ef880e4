"""How much was given to an adjustment and how much of it took part: one definition, wherever it is reported."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.adjustment.evaluation.check_points import used_rays
from raybundle.adjustment.result import Adjustment


@dataclass(frozen=True, slots=True, kw_only=True)
class Counts:
    """Numbers of images, object points and image observations (of two coordinates each).

    An image observation took part if it was not rejected; an image or an object point, if an observation of it did.
    """

    images_given: int
    images_used: int
    points_given: int
    points_used: int
    image_observations_given: int
    image_observations_used: int

    @property
    def rejected(self) -> int:
        """Image observations that were given and took no part."""
        return self.image_observations_given - self.image_observations_used


def counts(a: Adjustment) -> Counts:
    """What was given to an adjustment and what took part."""
    o, used = a.given.observations, a.image_observations.used
    return Counts(
        images_given=len(a.given.images),
        images_used=int(np.count_nonzero(np.bincount(o.image[used]))),
        points_given=len(a.given.points),
        points_used=int(np.count_nonzero(used_rays(a))),
        image_observations_given=len(o),
        image_observations_used=int(np.count_nonzero(used)),
    )
