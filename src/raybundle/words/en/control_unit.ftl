# $n = 8
# $before_m = 120.0
# $after_m = 0.02
# $ids = ["A", "B"]
control_unit = The heights of the control seem to be in feet; no control takes part.
    .why = The { $n } points fit the photographs to { NUM($before_m, digits: 2) } m as given, and to { NUM($after_m, digits: 2) } m in metres.
    .do = Give heights in metres (feet times 0.3048).

# $point = "A"
# $factor = 0.001
# $millimetres = true
# $before_m = 1200.0
# $after_m = 0.02
# $few = false
# $least = 3
# $ids = ["A"]
control_unit-point = Point { $point } seems to be in { $millimetres ->
     [yes] millimetres, the others in metres
     *[no] metres, the others in millimetres
    }; { $few ->
     [yes] no control takes part (fewer than { $least } points remain)
     *[no] it takes no part
    }.
    .why = It is { NUM($before_m, digits: 2) } m from where the others place it, and { NUM($after_m, digits: 2) } m with the factor { $factor }.
    .do = Give all coordinates in one unit.
