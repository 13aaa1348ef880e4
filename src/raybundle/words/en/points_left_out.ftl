# $n = 4
points_left_out = { $n } { $n ->
        [one] point was
       *[other] points were
    } excluded: the rays do not intersect.
    .why = The result has no coordinates of these points; the other points are not affected.
    .do = If these points are needed, measure them in photographs from other directions.
