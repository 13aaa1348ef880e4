"""Functions that do tasks, by name: a list of tasks may come from somebody else, and names what is called.

A module of tasks outside raybundle is permitted by its name in RAYBUNDLE_TASK_MODULES (several: with commas).
"""

from __future__ import annotations

import os

VARIABLE = "RAYBUNDLE_TASK_MODULES"
FUNCTIONS = {
    "raybundle.blocking.answers": (
        "describe", "touched", "evaluate", "residuals", "expand", "astray", "moments", "placed", "generators",
        "statistics", "reported", "stated", "tested",
    ),
    "raybundle.blocking.fields": ("widen", "moved", "projected", "squared", "retained"),
    "raybundle.blocking.tasks": ("up", "down", "right_up", "right_down", "inverse"),
    "raybundle.ties.pairs": ("words_product", "signature_product", "compared"),
    "raybundle.ties.parts": ("grown", "settled"),
    "raybundle.ties.points": ("features_of", "pair_of"),
    "raybundle.ties.tracks": ("tracks_within",),
    "raybundle.ties.windows": ("windows_of",),
    "raybundle.surfaces.orthophoto_pixels": ("part_of_orthophoto",),
    "raybundle.workflows.scenes.ties": ("scene_features_of", "scene_pair_of"),
    "raybundle.surfaces.stages.fusion": ("sigma_of", "cloud_of"),
    "raybundle.surfaces.stages.heights": ("above_of", "tile_of", "steps_in"),
    "raybundle.surfaces.stages.visibility": ("look_of",),
    "raybundle.surfaces.stages.depth_maps": ("map_of",),
    "raybundle.surfaces.stages.orthophoto": ("choice_of",),
    "raybundle.workflows.target_tasks": ("targets_of",),
}  # fmt: skip
"""By module; a function that takes a store and options and is missing here fails tests/pipeline/test_foreign.py."""


def is_registered(module: str, function: str) -> bool:
    """Whether a task may call this function; nothing is imported."""
    more = {name.strip() for name in os.environ.get(VARIABLE, "").split(",")} - {""}
    return function in FUNCTIONS.get(module, ()) or (module in more and function.isidentifier())
