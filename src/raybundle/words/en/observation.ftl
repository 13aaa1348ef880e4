# $sxy_px2 = 0.5
# $limit_px2 = 0.25
observation-covariance = The covariance { $sxy_px2 } px² is outside ± { $limit_px2 } px², the product sx · sy.
    .do = Correct it, or leave it empty.

# $sx_px = 1e-200
# $sy_px = 0.5
observation-sigma_out_of_range = Standard deviations of { $sx_px } and { $sy_px } px are not plausible.
    .do = Give them in px.

# $correlation = 1.2
observation-correlation_range = { $correlation } is not a correlation coefficient: it must lie between -1 and 1.
    .do = Divide a covariance by both standard deviations.

# $correlation = 0.5
# $first = "sX"
# $second = "sY"
observation-correlation_without_sigma = A correlation of { $correlation } belongs to a value that is not observed.
    .do = Leave it empty, or give { $first } and { $second }.

# $correlations = [0.9, 0.9, -0.9]
# $eigenvalue = -0.8
# $limit = 1e-06
observation-correlations_not_possible = Correlations { $correlations } are not possible together (least eigenvalue { NUM($eigenvalue, digits: 2) }, limit { $limit }).
    .why = Their matrix is not positive definite.
    .do = Give more digits, or correct them.

observation-image_twice = This image already has a row.
    .do = Delete one of the two rows.

observation-no_sigma = No angle of this row has a standard deviation.
    .do = Give one, or delete the row.

observation-value_without_sigma = A value has no standard deviation, or a standard deviation no value.
    .do = Give both, or leave both empty.

observation-no_value = The row has no observed value.
    .do = Delete the row.

# A kind of observation of one's own refuses a row
# $detail = "an azimuth needs two different points"
observation-row_refused = This row cannot be used: { $detail }.
    .do = Correct the row, or delete it.

observation-same_point = Both points of this row are the same.
    .do = Give two different points.

# $set = "S1"
observation-set_station = Set { $set } has another station in an earlier row.
    .do = Give each set one station.

# $angle_deg = 271.5
observation-zenith_angle = { NUM($angle_deg, digits: 6) }° is not a zenith angle (0° to 180°, 0 to 200 gon).
    .do = For face two, give 360° (400 gon) minus the reading.

# $parameter = "c"
observation-parameter_twice = { $parameter } of this image already has a row.
    .do = Delete one of the two rows.
