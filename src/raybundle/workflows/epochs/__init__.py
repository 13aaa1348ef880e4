"""Photographs of several dates in one adjustment: object points of each date, and which of them are one place."""
