"""Sensor models; every module in this folder registers itself on import."""

from importlib import import_module
from pkgutil import iter_modules

from raybundle.sensors.model import Parameter, ProjectionDiverged, SensorModel

for _module in iter_modules(__path__):
    if _module.name not in {"model", "generated"}:
        import_module(f"{__name__}.{_module.name}")

sensor_models = SensorModel.registry

__all__ = ["Parameter", "ProjectionDiverged", "SensorModel", "sensor_models"]
