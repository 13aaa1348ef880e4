"""Flights: way points, patterns over an area, what a vehicle can do."""
