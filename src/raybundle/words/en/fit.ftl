# $names = ["A7", "A9"]
fit-unknown_points = Points selected for the fit are not both measured and nominal: { $names }.
    .do = Correct the names, or leave these points out.

# $n = 2
# $names = ["A1", "A2"]
# $least = 3
fit-too_few_selected = Only { $n } points are selected for the fit ({ $names }).
    .do = Select at least { $least } points.

# $n = 2
# $nominal = 8
# $least = 3
# $missing = ["A3", "A4"]
fit-too_few_common = { $n } of { $nominal } nominal points are measured under the same name; a fit needs { $least }.
    .do = Use the same names in both; not measured: { $missing }.

# $n = 3
# $names = ["A1", "A2", "A3"]
# $kind = "measured"
fit-points_in_line = The { $n } { $kind ->
        [nominal] nominal
       *[measured] measured
     } points of the fit lie in one line, or are one point.
    .why = The rotation about this line is not determined ({ $names }).
    .do = Select three points that are not in one line.

fit-covariance_singular = The joint covariance matrix of the fitted points is singular.
    .why = Some of these points are held without error.
    .do = Fit with equal weights.

# $ratio = 1000.2
# $likely = true
# $units = "mm for m"
fit-other_unit = Nominal points are { NUM($ratio, digits: 4) } times as far apart as the measured ones.
    .why = Their unit or that of the scale bars is wrong{ $likely ->
        [yes] { " " }(likely { $units })
       *[no] { "" }
     }.
    .do = Give scale bars in metres; { OPTION("unit", 0.001) } reads files in millimetres.
