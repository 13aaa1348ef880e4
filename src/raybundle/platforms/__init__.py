"""Where a sensor stands: stations, rigs and read-outs; every sensor on every platform that can carry it is a model.

A module in this folder that states a `Platform` registers it on import.
"""

from importlib import import_module
from pkgutil import iter_modules

from raybundle.platforms.carried import Carried, register_carried
from raybundle.platforms.platform import Platform
from raybundle.sensors.model import SensorModel

for _module in iter_modules(__path__):
    if _module.name != "generated":
        import_module(f"{__name__}.{_module.name}")

platforms, sensor_models = Platform.registry, SensorModel.registry
for _sensor in [*SensorModel.registry.values()]:
    register_carried(_sensor)
SensorModel.followers.append(register_carried)

__all__ = ["Carried", "Platform", "platforms", "sensor_models"]
