# $n = 12
# $limit_deg = 1.0
# $ids = ["t1", "t2"]
small_angle = { $n } object { $n ->
        [one] point is
       *[other] points are
     } intersected at less than { $limit_deg }°: { $ids }.
    .why = Their depth is weakly determined.
