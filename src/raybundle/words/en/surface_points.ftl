# $name = "block"
# $n = 5
# $least = 10
surface_points-too_few = { $name }: { $n } points have rays; a surface needs { $least }.
    .do = Give a result with more object points.
