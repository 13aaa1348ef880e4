# $n = 3
tie_points-too_few_rays = { $n } tie { $n ->
        [one] point has
       *[other] points have
     } fewer than two rays.
    .do = Remove these points from points.csv and observations.csv, or measure them in more images.

# $n = 2
# $points = ["P1", "P2"]
tie_points-no_ray = Points without a ray: { LIST($points, most: 10) }.

# $n = 2
# $points = ["P1", "P2"]
tie_points-single_ray = Points with a single ray: { LIST($points, most: 10) }.

# $n = 12
tie_points-no_base = The { $n } matching pairs of photographs have no base: they differ by a rotation of the camera only.
    .why = Photographs from one place give no depth.
    .do = Move sideways between photographs, by a tenth of the distance to the object or more.

tie_points-too_few_common = No two photographs have enough common tie points for a relative orientation.
    .do = Take sharp photographs with 60 % overlap or more and small differences in direction.

tie_points-none_after_cleaning = After the rejection of wrong matches, no two photographs have enough common tie points.
    .do = Take sharp photographs with 60 % overlap or more and small differences in direction.
