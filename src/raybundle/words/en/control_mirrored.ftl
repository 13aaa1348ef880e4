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
control_mirrored = The control coordinates of { $name } are mirrored: mirrored they fit to { NUM($rms_mm, digits: 2) } mm rms.
    .why = No control point takes part.
    .do = Correct the axes in the file: two are exchanged, or one has the opposite sign.

# $n = 8
# $rms_m = 1.2
# $mirrored_m = 0.01
# $ids = ["A", "B", "C"]
control_mirrored-points = The coordinates of { $n } control and check points are mirrored; no control takes part: { LIST($ids, most: 8) }.
    .why = They fit the photographs to { NUM($rms_m, digits: 2) } m as given, and to { NUM($mirrored_m, digits: 2) } m mirrored.
    .do = Correct the axes in the file: two are exchanged, or one has the opposite sign (depths for heights).

# $n = 8
# $before_m = 1200.0
# $after_m = 0.02
# $geographic = false
# $ids = ["A", "B"]
control_mirrored-axes = { $geographic ->
     [yes] Latitude and longitude
     *[no] Easting and northing
    } of the control seem to be exchanged; no control takes part.
    .why = The { $n } points fit the photographs to { NUM($before_m, digits: 2) } m as given, and to { NUM($after_m, digits: 2) } m exchanged.
    .do = Exchange the two columns in the file of control.
