# $n = 2
# $ids = ["t1", "t2"]
start_parallel = { $n } { $n ->
        [one] point has
       *[other] points have
     } nearly parallel rays in the approximate values: { $ids }.
