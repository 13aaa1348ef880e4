"""Heights on a grid: differences, displacements, volumes, areas, sections, contours with standard deviations."""
