# $name = "control.csv"
# $n = 12
# $agree = 5
# $rms_mm = 0.31
# $rms_same_scale_mm = 2.4
# $factor = 1.0012
# $factor_sigma = 2e-05
# $scale_ppm = 1200.0
# $sigma_ppm = 20.0
# $near_1 = true
# $units = ""
# $ids = ["A", "B"]
control_contradicts-scattered = Control of { $name } does not fit: only { $agree } of { $n } points agree, to { NUM($rms_mm, digits: 2) } mm rms.
    .why = No control point takes part, so the axes are not those of the control.
    .do = Check the point names and coordinates of the file.

# $name = "control.csv"
# $n = 12
# $agree = 5
# $rms_mm = 0.31
# $rms_same_scale_mm = 2.4
# $factor = 1.0012
# $factor_sigma = 2e-05
# $scale_ppm = 1200.0
# $sigma_ppm = 20.0
# $near_1 = true
# $units = ""
# $ids = ["A", "B"]
control_contradicts-scale = Control of { $name } and the scale bars differ in scale by { $near_1 ->
        [yes] { NUM($scale_ppm, digits: 4) } ppm
       *[no] a factor of { NUM($factor, digits: 6) }
     }.
    .why = No control point takes part; the scale is that of the scale bars ({ NUM($rms_same_scale_mm, digits: 2) } mm rms without the factor).
    .do = Check the unit of the file and the lengths of the scale bars.

# $name = "control.csv"
# $n = 2
# $rms_mm = 0.03
# $ids = ["A", "B"]
control_contradicts-ambiguous = { $n } control points of { $name } contradict the others; which points are wrong is ambiguous.
    .why = All control takes part, so a wrong coordinate distorts the result.
    .do = Check coordinates and names of { $ids }, or add control points.

# $points = 3
# $control = 5
# $limit = 0.5
# $ids = ["A", "B", "C"]
control_contradicts-rejected = { $points } of { $control } control points have more than { PERCENT($limit) } % of their image points rejected: { $ids }.
    .why = The control contradicts the photographs, or its names are exchanged.
    .do = Check coordinates, coordinate system, order and signs of the axes, unit and names.
