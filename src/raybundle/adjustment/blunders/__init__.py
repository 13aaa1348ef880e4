"""Which observations, control points, scale bars or images contradict the others."""
