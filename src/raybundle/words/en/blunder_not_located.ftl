# $n = 23
# $ids = ["t1", "t2"]
blunder_not_located = { $n } { $n ->
        [one] point was
       *[other] points were
     } dropped: too few rays to identify the wrong ray.
    .why = Fewer than three rays would remain, or two rays explain the error equally well: { $ids }.
    .do = Measure these points in more photographs.
