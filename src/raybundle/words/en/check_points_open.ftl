# $points = 4
# $axes = ["Z"]
# $n = 1
# $part = "position_z"
# $ids = ["C1"]
check_points_open = Check points are not compared in { $axes }; not determined: { datum-part }.
    .why = Coordinates that depend on it are arbitrary.
