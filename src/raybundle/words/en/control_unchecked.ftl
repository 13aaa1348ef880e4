# $n = 2
# $ids = ["A", "B"]
control_unchecked = { $n } control { $n ->
        [one] point is
       *[other] points are
     } unchecked by the other observations: { $ids }.
    .why = An error there distorts the result unnoticed.
    .do = Add control points or check points.

# $axis = "X"
# $n = 1
# $points = ["A"]
# $least = 29.0
# $point = "A"
# $unit = "m"
control_unchecked-axis = { $axis } of { $points }: an error below { NUM($least, digits: 2) } { $unit } at { $point } would not be noticed.

# $axis = "X"
# $n = 1
# $points = ["A"]
control_unchecked-no_limit = { $axis } of { $points }: no error would be noticed, however large.
