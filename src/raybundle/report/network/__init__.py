"""The page of a network in three dimensions."""
