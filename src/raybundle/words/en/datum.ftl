# $n = 2
# $points = ["P1", "P2"]
datum-unknown_points = { $n } datum { $n ->
        [one] point takes
       *[other] points take
     } no part in the adjustment: { LIST($points, most: 5) }.
    .do = Choose datum points that are measured.

datum-points_in_line = The object points cannot define the datum: they lie in one place or in a line.
    .do = Measure points beside this line.

datum-fixed = The observations fix the datum of this block; no other datum can be chosen.
    .do = Use the standard deviations of the result, or adjust the block without control and scale.

# $part = "scale"
# $n = 1
datum-part = { $part ->
        [position_x] position in X
        [position_y] position in Y
        [position_z] position in Z
        [rotation_x] rotation about X
        [rotation_y] rotation about Y
        [rotation_z] rotation about Z
        [scale] scale
        [about_line] rotation about a straight line
       *[several] several datum parameters
     }

# $n = 1
# $among = ["tX", "rZ"]
datum-combination = { $n } { $n ->
        [one] combination
       *[other] combinations
     } of { LIST($among, most: 7) } (t shift, r rotation, m scale)

# $points = 2
# $constraints = 7
datum-too_few_points = { $points } datum points cannot carry { $constraints } inner constraints.
    .do = Choose at least three points that are not in one line.

# $unit = "m"
# $n = 1
datum-no_scale = No observation determines the scale.
    .why = Standard deviations in { $unit } have no meaning without it.
    .do = Give a scale bar, control points or observed projection centres, or remove these observations.

# $free = 1
# $n = 1
# $part = "scale"
datum-not_by_control = Not determined by control: { datum-part }.
    .why = { $free } of 7 datum parameters { $free ->
        [one] is
       *[other] are
     } free.
    .do = Give more control points, a scale bar or observed projection centres, or use { OPTION("datum", "auto") }.

# $n = 1
# $part = "rotation_z"
datum-misalignment_unknown = Not determined: { datum-part }; the misalignment of the IMU is unknown.
    .why = The headings of the images are too similar to separate it from a rotation of the block.
    .do = Give control points or observed projection centres, hold bz, or give the misalignment a sigma.

# $n = 1
# $part = "position_x"
datum-antennas_unknown = Not determined: { datum-part }; the GNSS antenna offsets are unknown.
    .why = Shifts, drifts or lever arms of the projection centres are free for every flight line.
    .do = Give control points, hold the shift of one antenna, or give the shifts a sigma.

# $n = 1
# $part = "rotation_z"
datum-directions_unknown = Not determined: { datum-part }; the orientations of the sets of directions are unknown.
    .why = No other observation determines the rotation about the vertical.
    .do = Give two control points in plan.
