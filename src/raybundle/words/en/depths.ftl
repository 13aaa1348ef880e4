# $angle_deg = 0.4
# $least_deg = 2.0
depths-small_angle = The rays of these photographs meet at { NUM($angle_deg, digits: 2) }° (median); { $least_deg }° are needed.
    .why = The base is too short or along the viewing direction.
    .do = Take photographs from positions farther apart.

# $ratio = 3.1
# $limit = 2.0
depths-scales_differ = The scales of these photographs differ by a factor of { NUM($ratio, digits: 2) } (limit { $limit }).
    .do = Take photographs from similar distances.

depths-no_common_points = No two photographs have enough common points.

depths-no_partner = No other photograph has enough common points with this photograph.

depths-no_useful_partner = No other photograph forms a useful pair with this photograph.

depths-region_not_shown = The photograph does not show the region.
