"""Satellite scenes on their way through `orient`."""
