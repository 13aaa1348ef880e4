"""What a calibration is worth, beside its numbers: maps, cross-validation, what to photograph next, zoom lenses."""
