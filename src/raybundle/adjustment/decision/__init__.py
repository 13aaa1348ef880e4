"""Decisions that adjust again: blunders, parameters of the interior orientation, variance groups."""
