# $n = 4
points_left_out = { $n } { $n ->
        [one] point was
       *[other] points were
    } excluded: the rays do not intersect.
