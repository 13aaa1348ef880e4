# $n = 1
# $ids = ["M1 - M2"]
distance_lost = { $n } { $n ->
        [one] distance takes
       *[other] distances take
     } no part: image points of the ends were rejected ({ $ids }).
    .do = Check the marks of these points.
