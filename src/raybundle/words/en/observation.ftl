# $sxy_px2 = 0.5
# $limit_px2 = 0.25
observation-covariance = The covariance { $sxy_px2 } px² is outside ± { $limit_px2 } px², the product sx · sy.
    .do = Correct it, or leave it empty.

# $sx_px = 1e-200
# $sy_px = 0.5
observation-sigma_out_of_range = Standard deviations of { $sx_px } and { $sy_px } px are not plausible.
    .do = Give them in px.
