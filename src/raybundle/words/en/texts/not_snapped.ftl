# $distance_px = 14.2
# $limit_px = 12.0
not_snapped-far = The point found lies { NUM($distance_px, decimals: 1) } px from the click (limit { $limit_px } px).
    .do = Click nearer.

not_snapped-margin = The picture around the click is too small.

# $reach_px = 12.0
not_snapped-no_target = No round target lies within { $reach_px } px.
    .do = Click into it, or choose another kind.

# $distance_px = 14.2
# $limit_px = 12.0
not_snapped-target_far = The nearest round target lies { NUM($distance_px, decimals: 1) } px away (limit { $limit_px } px).

# $reach_px = 12.0
# $kind = "corner"
not_snapped-no_edges = No edges of two directions meet within { $reach_px } px.
    .do = Click nearer to the { $kind ->
        [corner] corner
        *[cross] cross
    }.

# $kind = "corner"
not_snapped-other_grey_values = The grey values are not those of a { $kind ->
        [corner] corner
        *[cross] cross
    }.

# $kind = "corner"
not_snapped-no_place = The grey values do not determine the position of a { $kind ->
        [corner] corner
        *[cross] cross
    }.

# $contrast = 5.0
# $limit = 8.0
not_snapped-contrast = The contrast is { NUM($contrast, decimals: 0) } grey values (limit { $limit }).

# $angle_deg = 12.0
# $limit_deg = 30.0
not_snapped-angle = The edges meet at { NUM($angle_deg, decimals: 0) }° (limit { NUM($limit_deg, decimals: 0) }°).

# $kind = "corner"
# $residual = 0.15
# $limit = 0.1
not_snapped-grey_values = The grey values differ from a { $kind ->
        [corner] corner
        *[cross] cross
    } by { NUM($residual, decimals: 2) } of the contrast (limit { $limit }).

# $sigma_px = 0.42
# $limit_px = 0.3
# $texture = true
not_snapped-sigma = The standard deviation is { NUM($sigma_px, decimals: 2) } px (limit { $limit_px }){ $texture ->
        [yes] {""}
        *[no] : too little texture
    }.

# $reach_px = 12.0
# $correlation = 0.42
# $limit = 0.5
not_snapped-nothing_alike = Nothing within { $reach_px } px resembles the other picture (correlation { NUM($correlation, decimals: 2) }, limit { $limit }).

# $distance_px = 6.3
not_snapped-two_alike = Two places { NUM($distance_px, decimals: 1) } px apart look alike.
    .do = Choose another kind.

# $outcome = "left"
not_snapped-no_convergence = Least-squares matching did not converge ({ $outcome }).

# $correlation = 0.62
# $limit = 0.7
not_snapped-correlation = The pictures correlate by only { NUM($correlation, decimals: 2) } (limit { $limit }).
