# $name = "P1"
plane-points_in_line = Plane { $name }: its points lie on a straight line.
    .why = The plane can rotate about this line.
    .do = Add a point beside the line.

# $deviation = 0.01
# $limit = 1e-06
plane-axes_not_orthogonal = right, up and normal are not right-handed orthogonal unit vectors (off by { $deviation }, limit { $limit }).
    .do = Write the file again.

plane-place_unknown = The position of the plane in space is unknown; right, up and normal are missing.
    .do = Rectify the photograph again.

# $plane = "mm"
# $block = "m"
plane-other_unit = The unit of the plane is { $plane }, that of the block { $block }.
    .do = Give the plane of a picture of this block.
