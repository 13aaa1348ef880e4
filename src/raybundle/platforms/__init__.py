"""Where a sensor stands: stations, rigs, read-outs, trajectories; each sensor on each that carries it is a model.

Beside sensors a platform carries instruments: GNSS antennas and IMUs.
A module in this folder that states a `Platform` or an `InstrumentModel` registers it on import.
"""

from importlib import import_module
from pkgutil import iter_modules

from raybundle.platforms.carried import Carried, register_carried, register_platform
from raybundle.platforms.instrument import InstrumentModel
from raybundle.platforms.platform import Platform
from raybundle.sensors.model import SensorModel

for _module in iter_modules(__path__):
    if _module.name != "generated":
        import_module(f"{__name__}.{_module.name}")

platforms, sensor_models, instrument_models = Platform.registry, SensorModel.registry, InstrumentModel.registry
for _sensor in [*SensorModel.registry.values(), *SensorModel.lines.values()]:
    register_carried(_sensor)
SensorModel.followers.append(register_carried)
Platform.followers.append(register_platform)

__all__ = ["Carried", "InstrumentModel", "Platform", "instrument_models", "platforms", "sensor_models"]
