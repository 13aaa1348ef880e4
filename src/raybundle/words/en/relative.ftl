# $n = 5
relative-too_few_points = { $n } common points are given; a relative orientation needs six.
    .do = Measure more common points.

# $n = 40
# $limit_px = 4.0
relative-no_solution = No relative orientation fits six of { $n } points within { $limit_px } px.
    .do = Check that the points have the same name in both images.

# $angle_deg = 0.05
relative-parallel_rays = The rays of common points are parallel within { NUM($angle_deg, decimals: 3) }°.
    .why = The images have almost no base, or all points are far away.
    .do = Use images from different stations.
