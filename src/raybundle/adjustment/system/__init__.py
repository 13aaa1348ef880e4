"""From a block to its normal equations and their solution: unknowns, observations, datum, factor."""
