"""What people compute from the heights of a surface: volumes, sections, contours, the ground, what has moved."""
