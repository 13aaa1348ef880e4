# $n = 3
tie_points-too_few_rays = { $n } tie { $n ->
        [one] point has
       *[other] points have
     } fewer than two rays.
    .do = Remove these points from points.csv and observations.csv, or measure them in more images.

# $n = 2
# $points = ["P1", "P2"]
tie_points-no_ray = No ray: { LIST($points, most: 10) }

# $n = 2
# $points = ["P1", "P2"]
tie_points-single_ray = A single ray: { LIST($points, most: 10) }
