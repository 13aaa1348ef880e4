"""Files that show the geometry of satellite scenes; every module in this folder registers its format on import.

A new format is one new file: it makes a `SceneFormat` and hands it to `register`.
"""

from importlib import import_module
from pkgutil import iter_modules

from raybundle.io.scenes.agreement import agreement_of, check_agreement, remarks_of
from raybundle.io.scenes.base import (
    Scene,
    SceneFormat,
    companions_of,
    file_of_product,
    is_scene,
    read_scene,
    scene_formats,
)

for _module in iter_modules(__path__):
    import_module(f"{__name__}.{_module.name}")

__all__ = [
    "Scene",
    "SceneFormat",
    "agreement_of",
    "check_agreement",
    "companions_of",
    "file_of_product",
    "is_scene",
    "read_scene",
    "remarks_of",
    "scene_formats",
]
