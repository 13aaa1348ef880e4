"""Least squares adjustment of blocks: assembly, solution, datum, precision, reliability, decisions."""
