projective-not_metric = No camera constants make the projective model metric.
    .do = Give the camera constant of one camera, or use images with convergent axes, some of them rolled.

# $least = 8
projective-no_pair = No pair of images determines a fundamental matrix.
    .why = It needs { $least } common points of different depth.
    .do = Measure more common points.

# $image = "left.jpg"
# $other = "right.jpg"
projective-pair = The pair { $image } and { $other } has no fundamental matrix.
