# $name = "rotation"
# $shape = [2, 3]
# $needed = [3, 3]
transform-wrong_shape = Array { $name } of a transformation: shape ({ $shape }), or values that are not finite.
    .do = Give finite numbers of shape ({ $needed }).

# $value = "'move'"
transform-observed_unknown = observed = { $value } is unknown.
    .do = Give "follow" or "stay".

# $scale = -1.0
transform-scale_not_positive = The scale of the transformation is { $scale }.
    .do = Give a value above 0.

# $translation = [1.0, 2.0, "nan"]
transform-translation_not_finite = The translation of the transformation is { $translation }.
    .do = Give three finite numbers.

# $scene = "pleiades"
transform-scene = Satellite scene { $scene } cannot be transformed.
    .why = Its model gives longitude, latitude and height.
    .do = Transform a block without satellite scenes.

transform-geodetic_frame = The object frame has a fixed place on the Earth and cannot be transformed.
    .do = Remove the place from the block (place=None).

# $off = 0.01
# $limit = 1e-09
transform-rotation_not_orthogonal = The rotation of the transformation is not orthogonal: R R' differs from 1 by { NUM($off, digits: 2) } (limit { $limit }).
    .do = Give an orthogonal matrix of determinant +1.

transform-rotation_mirrored = The rotation of the transformation is a reflection.
    .do = Give an orthogonal matrix of determinant +1.

# $name = "d5100"
# $parameters = ["X", "Y", "Z"]
transform-sigmas_correlated = { $name } cannot be transformed: standard deviations of { $parameters } would be correlated.
    .do = Use equal standard deviations, or transform without rotation.

# $name = "d5100"
# $parameters = ["X", "Y", "Z"]
transform-partly_free = { $name } cannot be rotated: some of { $parameters } are fixed, others free.
    .do = Free or fix all of them.

# $name = "d5100"
# $parameter = "Z"
transform-calibration_incomplete = { $name } cannot be rotated: its calibration has no value of { $parameter }.
    .do = Calibrate with this parameter, or transform without rotation.

# $row = "row 3"
transform-row_not_possible = { $row } cannot be transformed:
    .do = Delete this row before the transformation, or keep the present frame.

transform-not_given = A coordinate is missing that the rotation combines with the given ones.

transform-would_correlate = Its coordinates would be correlated, which standard deviations alone cannot state.

transform-coefficients = Its correlation coefficients are not those of observed quantities.
    .why = Their matrix is not positive definite, or a standard deviation is missing.

# $kind = "coordinate"
transform-not_observed = One { $kind ->
        [coordinate] coordinate
        *[angle] angle
    } was not observed that the rotation combines with the observed ones.
    .do = Give it a standard deviation, or leave the row out.

# $kind = "coordinate"
# $eigenvalue = 1e-12
# $limit = 1e-10
transform-too_correlated = Its { $kind ->
        [coordinate] coordinates
        *[angle] angles
    } would be correlated too closely: least eigenvalue { NUM($eigenvalue, digits: 2) } (limit { $limit }).
    .why = Their standard deviations are too different.

transform-phi_near_right_angle = phi would be near a right angle.
    .why = There, omega and kappa rotate about the same axis.

# $angle_deg = 12.0
transform-vertical_turned = The row refers to the vertical, which is turned by { $angle_deg }°.

transform-heights_tilted = Instrument and target heights are along the vertical, which is tilted.
