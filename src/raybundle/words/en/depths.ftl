# $angle_deg = 0.4
# $least_deg = 2.0
depths-small_angle = Their rays meet at { NUM($angle_deg, digits: 2) }° (median); { $least_deg }° are needed.
    .why = The base is too short or along the viewing direction.

# $ratio = 3.1
# $limit = 2.0
depths-scales_differ = Their scales differ by a factor of { NUM($ratio, digits: 2) } (limit { $limit }).

depths-no_common_points = No two photographs have enough common points.

depths-no_partner = No other photograph has enough common points with it.

depths-no_useful_partner = No other photograph forms a useful pair with it.

depths-region_not_shown = It does not show the region.
