"""Figures of the report, and what draws them."""
