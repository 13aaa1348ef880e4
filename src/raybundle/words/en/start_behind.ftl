# $n = 2
# $ids = ["t1", "t2"]
start_behind = { $n } { $n ->
        [one] point has
       *[other] points have
     } rays that intersect behind a camera in the approximate values: { $ids }.
