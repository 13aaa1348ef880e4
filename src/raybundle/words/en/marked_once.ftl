# $n = 2
# $ids = ["P1", "P2"]
marked_once = { $n } { $n ->
     [one] point is
     *[other] points are
    } measured in one photograph only and not determined: { $ids }.
    .do = Measure them in a second photograph.
