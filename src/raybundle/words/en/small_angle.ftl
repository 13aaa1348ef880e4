# $n = 12
# $limit_deg = 1.0
# $ids = ["t1", "t2"]
small_angle = { $n } object { $n ->
        [one] point is
       *[other] points are
     } intersected at less than { $limit_deg }°: { $ids }.
    .why = The depth of these points is weakly determined; their standard deviations contain this.
    .do = If the depth of these points matters, photograph them from a station to the side.
