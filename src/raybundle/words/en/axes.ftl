# $which = "axis"
axes-point_missing = Coordinate system: the { $which ->
        [origin] origin
       *[axis] axis point
     } is missing.
    .do = Give origin and axis; add a plane point where no level or plumb line defines the vertical.

# $names = ["A", "A", "B"]
axes-same_points = Coordinate system: of the points { $names }, some are identical.
    .do = Give different points.

# $names = ["A", "B", "C"]
# $sine = 1e-05
# $limit = 0.0001
axes-in_line = Coordinate system { $names }: the points are on one line.
    .why = The sine of the angle at the origin is { NUM($sine, digits: 2) } (limit { $limit }).
    .do = Choose a plane point off the axis.

# $names = ["A", "B"]
# $sine = 1e-05
# $limit = 0.0001
axes-vertical = Coordinate system { $names }: the points are above each other, without a direction in plan.
    .why = The sine of the angle to the vertical is { NUM($sine, digits: 2) } (limit { $limit }).
    .do = Choose another axis point.

# $names = ["A", "B", "C"]
# $n = 3
# $width = 1e-06
# $limit = 0.0001
axes-level_no_plane = Level { $names }: the { $n } points define no plane.
    .why = They are too few, or on one line (width by length { NUM($width, digits: 2) }, limit { $limit }).
    .do = Give three or more points that are not on one line.

# $names = ["A", "B", "C"]
# $point = "A"
axes-no_coordinates = Coordinate system { $names }: point { $point } has no coordinates.
    .do = Mark it in two images.

# $names = ["A", "B", "C"]
# $tables = ["control"]
axes-contradicts_block = The coordinate system by points { $names } contradicts the datum of the block ({ $tables }).
    .do = Remove one of the two, or transform the result (raybundle datum).

# $names = ["A", "B"]
axes-no_vertical = The coordinate system by points { $names } has no vertical.
    .do = Measure a level or a plumb line, or give a third point in the XY plane.

# $both = false
axes-plane_or_level = Coordinate system: { $both ->
        [yes] a plane point and the points of a level are given
       *[no] neither a plane point nor the points of a level are given
     }.
    .do = Give one of them.

# $n = 1
axes-point_count = Points given: { $n }; a coordinate system needs three, two or none.
    .why = Two are enough where levels or plumb lines define the vertical.
    .do = Give origin, axis and plane, or origin and axis, or none.
