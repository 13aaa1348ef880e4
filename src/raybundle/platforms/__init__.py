"""Where a sensor stands: stations, rigs and trajectories place it in object space."""
