# $n = 2
# $ids = ["A", "B"]
one_ray_control = { $n } control { $n ->
        [one] point has
       *[other] points have
     } a single ray: { $ids }.
    .do = Measure each control point in at least two photographs.
