# $n = 5
dlt-too_few_points = { $n } points are given; a DLT needs six that are not in a plane.
    .do = Measure more points.

# $ratio = 1e-05
dlt-plane = The points are in a plane (depth { NUM($ratio, digits: 2) } of their extent).
    .why = A DLT needs depth.
    .do = Measure points in front of or behind the plane.

dlt-behind = The DLT places the points behind the camera.
    .why = The image is mirrored, or y counts downwards.
    .do = Correct the direction of the image axes.
