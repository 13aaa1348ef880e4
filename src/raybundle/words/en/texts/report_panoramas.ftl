report_panoramas-title = Panoramas

# $camera = "1"
report_panoramas-camera = Camera { $camera }

# $n = 4
# $points = 812
report_panoramas-count = { $n } { $n ->
        [one] panorama
        *[other] panoramas
    } with { $points } image points.

# $direction_from = 0.0
# $direction_to = 360.0
# $elevation_from = -20.0
# $elevation_to = 41.0
report_panoramas-extent = Direction { NUM($direction_from, decimals: 0) }° to { NUM($direction_to, decimals: 0) }°, elevation { NUM($elevation_from, decimals: 0) }° to { NUM($elevation_to, decimals: 0) }°.

# $arc_px = 0.41
# $line_px = 0.38
report_panoramas-rms = Residuals (rms): { $arc_px } px along the arc, { $line_px } px along the line.

report_panoramas-residuals = residuals

report_panoramas-no_trend = No mean residual changes significantly with direction or elevation.

report_panoramas-sketch = View from above. Bars: image points by direction.
    .why = Middle: axis of rotation (cross) and projection centre for a view upwards, enlarged, with its standard deviations.

# $p = 0.35
report_panoramas-chance = Probability by chance: { P($p) }.

# $arc = true
# $angle = "direction"
report_panoramas-against = Residuals along the { $arc ->
        [yes] arc
        *[no] line
    } against { $angle }, running mean; band: 95 % without trend.

# $arc = true
# $angle = "direction"
# $size_px = 0.4
report_panoramas-trend = The mean residual along the { $arc ->
        [yes] arc
        *[no] line
    } changes with { $angle }, by up to { NUM($size_px, digits: 2) } px.
    .why = Possible causes: eccentricity, tilt of the line, a tumbling axis, refraction.

# $angle = "direction"
report_panoramas-angle = { $angle }

report_panoramas-eccentricity = eccentricity

report_panoramas-eccentric = The projection centre is beside the axis of rotation.

# $symbol = "e"
# $value = 12.1
# $sigma = 0.4
# $unit = "mm"
report_panoramas-offset = { $symbol ->
        [e] Along
        *[d] Across
    } the view: { NUM($value, digits: 5) } ± { NUM($sigma, digits: 2) } { $unit }.
