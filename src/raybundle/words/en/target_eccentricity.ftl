# $n = 24
# $largest_px = 0.12
target_eccentricity = The centres of { $n } round targets were corrected for eccentricity, by up to { NUM($largest_px, digits: 2) } px.
