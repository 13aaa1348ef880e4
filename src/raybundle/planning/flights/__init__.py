"""Flights: aerial networks, missions, and what helps where they are weak."""
