joint-no_covariances = The adjustment has no covariances.
    .why = It was made without statistics, or is a copy.
    .do = Adjust again with statistics.

# $image = "left.jpg"
joint-image_not_used = Image { $image } is not in the adjustment.
    .do = Choose an image that takes part, or measure more points in this image and adjust again.

# $point = "P1"
joint-point_not_used = Point { $point } is not in the adjustment.
    .do = Choose a point that takes part, or measure this point in more images and adjust again.

# $name = "facade"
joint-no_named_points = { $name }: no adjusted point has a name of its own.
    .do = Measure targets, or mark points.

# $name = "facade"
# $n = 9000
# $most = 2000
joint-too_many_points = { $name }: { $n } points; a joint covariance is possible for { $most }.
    .do = Name some of the points.

# $point = "P9"
# $known = ["P1", "P2"]
joint-unknown_point = Point { $point } is not in the result.
    .why = The result has { $known }.
    .do = Correct the name.
