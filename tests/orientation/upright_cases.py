"""Ways to photograph: rotations and places of photographs in a frame whose Z is up."""

import numpy as np

from raybundle.numerics.rotation import rotation_from_vector
from raybundle.planning.synthetic_networks import look_at

UP = np.array([0.0, 0.0, 1.0])


def held(centre, aim, rng, roll_deg=1.5, turn=0.0):
    """Right and upward axes of photographs from `centre` (n, 3) towards `aim`, level but for the hand."""
    R = look_at(centre, np.broadcast_to(aim, centre.shape), np.radians(rng.normal(0, roll_deg, len(centre))) + turn)
    return R[:, 0], R[:, 1], centre


def nadir(rng, lines=4, each=6):
    """Strips to and fro, 100 m above the ground, tilted by some degrees."""
    x, y = np.meshgrid(np.arange(each) * 30.0, np.arange(lines) * 60.0)
    n = x.size
    centre = np.stack([x.ravel(), y.ravel(), np.full(n, 100.0) + rng.normal(0, 1, n)], axis=1)
    heading = np.repeat(np.arange(lines) % 2 * np.pi, each) + rng.normal(0, 0.05, n)
    tilt = rotation_from_vector(np.stack([*rng.normal(0, 0.05, (2, n)), np.zeros(n)], axis=1))
    R = tilt @ rotation_from_vector(np.stack([np.zeros(n), np.zeros(n), -heading], axis=1))
    return R[:, 0], R[:, 1], centre, 100.0


def oblique(rng):
    """A crossed flight with the camera 45 degrees below the horizon, to four sides."""
    found = []
    for k in range(4):
        a = k * np.pi / 2
        ahead = np.array([np.cos(a), np.sin(a), -1.0])
        centre = np.stack([*(rng.uniform(-100, 100, (2, 6))), np.full(6, 80.0)], axis=1)
        found.append(held(centre, centre + 80 * ahead, rng, 0.5))
    right, upward, centre = (np.concatenate(v) for v in zip(*found, strict=True))
    return right, upward, centre, 113.0


def facade(rng, n=12):
    """Along a facade, the camera pitched up by a few degrees, its azimuth as one likes."""
    centre = np.stack([np.linspace(-15, 15, n), -20 + rng.normal(0, 2, n), 1.6 + rng.normal(0, 0.1, n)], axis=1)
    aim = np.stack([rng.uniform(-8, 8, n), np.zeros(n), 4 + rng.normal(0, 1, n)], axis=1)
    return *held(centre, aim, rng), 20.0


def round_about(rng, n=16):
    """Round an object on the ground, looking down at it by 20 degrees; four photographs with the camera on its side."""
    a = np.linspace(0, 2 * np.pi, n, endpoint=False)
    centre = np.stack([4 * np.cos(a), 4 * np.sin(a), 1.5 + rng.normal(0, 0.1, n)], axis=1)
    turn = np.where(np.arange(n) % 4 == 3, np.pi / 2, 0.0)
    R = look_at(centre, np.zeros((n, 3)), np.radians(rng.normal(0, 2, n)) + turn)
    return R[:, 0], R[:, 1], centre, 4.3


def one_strip(rng, n=5):
    """Square to a plane, side by side, all upright: a facade on foot or a strip from the air, nobody can tell."""
    centre = np.stack([np.arange(n) * 3.0, np.full(n, -10.0) + rng.normal(0, 0.3, n), rng.normal(0, 0.3, n)], axis=1)
    aim = np.stack([rng.normal(0, 0.5, n), np.full(n, 10.0), rng.normal(0, 0.5, n)], axis=1)
    return *held(centre, centre + aim, rng, 2.0), 10.0


CASES = {
    "nadir": (nadir, "aerial"),
    "oblique": (oblique, "oblique"),
    "facade": (facade, "terrestrial"),
    "round_about": (round_about, None),
}
