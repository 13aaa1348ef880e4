"""Drawing sheets true to scale: paper, title block, grid, pictures, points and lines, as PDF."""
