# $n = 12
parallel_rays = { $n } tie { $n ->
        [one] point was
       *[other] points were
    } excluded: parallel rays have no depth.
