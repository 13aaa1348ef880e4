# $n = 8
# $beyond = 2
# $axes = ["X", "Z"]
# $ids = ["C1"]
check_points_apart = { $n } check { $n ->
        [one] point differs
       *[other] points differ
     } by more than standard deviations allow (in { $axes }).
    .why = Standard deviations of the result are not reliable until this is explained.
    .do = Check the coordinates, names, axes, unit and coordinate system of the check points, then the orientation.

# $axis = "X"
# $factor = 3.1
# $limit = 1.9
check_points_apart-axis = Coordinate { $axis }: differences are { NUM($factor, digits: 2) } times their standard deviations (limit { NUM($limit, digits: 2) }).

# $point = "C1"
# $axis = "X"
# $factor = 6.1
# $limit = 3.9
check_points_apart-point = Check point { $point } differs by { NUM($factor, digits: 2) } standard deviations in { $axis } (limit { NUM($limit, digits: 2) }).

check_points_apart-no_single_point = No single point stands out.
