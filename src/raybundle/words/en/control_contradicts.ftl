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

# $solved = true
# $sigma0 = 45.0
# $limit = 3.0
# $mended = 1.1
# $cause = "control"
# $mends = ["xy"]
# $ids = ["A", "B", "C", "D"]
control_contradicts-mirrored = The control is a mirror image of the object: sigma0 is { $mended } with mirrored control (limit { $limit }).
    .why = { $solved ->
     [yes] With the control as given, sigma0 is { $sigma0 }.
     *[no] With the control as given, the block has no solution.
    }
    .do = { $cause ->
     [images] Correct observations.csv: x counts to the right, y down. Cause:
     [open] Correct the file of control, or observations.csv. Possible causes:
     *[control] Correct the file of control. Possible causes:
    }

# $mend = "xy"
control_contradicts-mend = { $mend ->
     [xy] X and Y of the control are exchanged
     [yz] Y and Z of the control are exchanged
     [xz] X and Z of the control are exchanged
     [x] X of the control has the wrong sign
     [y] Y of the control has the wrong sign
     *[z] Z of the control has the wrong sign
    }

# $solved = true
# $sigma0 = 45.0
# $limit = 3.0
# $mended = 1.1
# $names = ["A", "B"]
# $ids = ["A", "B"]
control_contradicts-exchanged = Control points { $names } seem to be exchanged: sigma0 is { $mended } with their coordinates exchanged (limit { $limit }).
    .why = { $solved ->
     [yes] As given, sigma0 is { $sigma0 }.
     *[no] As given, the block has no solution.
    }
    .do = Exchange their coordinates in the file of control, or their names in the images.

# $solved = true
# $sigma0 = 45.0
# $limit = 3.0
# $mended = 1.1
# $n = 1
# $names = ["A"]
# $ids = ["A"]
control_contradicts-points = Control { $n ->
     [one] point { $names } contradicts
     *[other] points { $names } contradict
    } the photographs and the other control.
    .why = sigma0 is { $mended } without { $n ->
     [one] it
     *[other] them
    } (limit { $limit }); { $solved ->
     [yes] with all control it is { $sigma0 }
     *[no] with all control the block has no solution
    }.
    .do = Check coordinates and the names in the images, or leave out wrong points.

# $solved = true
# $sigma0 = 45.0
# $limit = 3.0
# $centres = 1.1
# $control = 1.2
# $ids = ["A", "B"]
control_contradicts-centres = Control and observed projection centres contradict each other.
    .why = sigma0 is { $centres } with the centres alone and { $control } with control alone (limit { $limit }); { $solved ->
     [yes] with both it is { $sigma0 }
     *[no] with both the block has no solution
    }.
    .do = Check height datum, coordinate system, axes and antenna offset, or leave one of the two out. Differences:

# $axis = "Z"
# $apart = 45.2
# $sigma = 0.1
control_contradicts-axis = Coordinate { $axis }: projection centres minus control are { $apart } (± { NUM($sigma, digits: 2) }).

# $solved = true
# $sigma0 = 45.0
# $limit = 3.0
# $alone = 1.1
# $n = 3
# $names = ["A", "B", "C"]
# $ids = ["A", "B", "C"]
control_contradicts-one_of_few = One of the control points { $names } is wrong; which one is ambiguous.
    .why = sigma0 is { $alone } without control (limit { $limit }); { $solved ->
     [yes] with it { $sigma0 }
     *[no] with it the block has no solution
    }.
    .do = Check coordinates, names and axes, or measure more control points.

# $solved = true
# $sigma0 = 45.0
# $limit = 3.0
# $alone = 1.1
# $n = 5
# $names = ["A", "B", "C", "D", "E"]
# $ids = ["A", "B", "C", "D", "E"]
control_contradicts-unexplained = The { $n } control points do not fit the photographs; no single point explains it.
    .why = sigma0 is { $alone } without control (limit { $limit }); { $solved ->
     [yes] with it { $sigma0 }
     *[no] with it the block has no solution
    }: { LIST($names, most: 10) }.
    .do = Check unit, coordinate system, axes, names and coordinates of the control.
