"""Where a block stands: control, scale, positions, attitudes, coordinate systems, and what contradicts them."""
