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

plane-vertical_and_horizontal = A plane cannot be { OPTION("vertical", "True") } and { OPTION("horizontal", "True") }.
    .do = Give one of them.

# $n = 2
# $least = 3
# $vertical = false
plane-too_few_points = The plane has { $n } { $n ->
        [one] point
       *[other] points
    }; { $least } are needed.
    .do = { $vertical ->
        [yes] Name more points
       *[no] Name more points, or two with { OPTION("vertical", "True") }
    }.

# $point = "P12"
plane-point_twice = Point { $point } of the plane is named twice.
    .do = Name another point.

# $system = "EPSG:4326"
plane-no_projected_system = { $system } is not a projected coordinate system; a picture needs one.
    .do = Give a projected system: { OPTION("crs") }.

plane-points_above_each_other = The points of the plane are above each other, so a vertical plane has no direction.
    .do = Name a point beside them.

plane-points_on_line = The points of the plane are on one line.
    .do = Name other points.

# $first = "A"
# $second = "B"
plane-axis_no_direction = { OPTION("axis", $first, $second) }: seen in the plane, the points are behind each other.
    .do = Choose two points that are apart in the plane.

# $back = true
# $lean_deg = 15.2
# $sigma_known = true
# $sigma_deg = 0.4
# $limit_deg = 11.3
plane-leans = The points lean { $back ->
        [yes] back
        *[no] forward
    } by { NUM($lean_deg, digits: 2) }{ $sigma_known ->
        [yes] {" "}± { NUM($sigma_deg, digits: 2) }
        *[no] {""}
    } degrees; no wall leans by more than { NUM($limit_deg, digits: 2) } degrees.
    .do = Check one by one whether the points lie in one wall, and whether the vertical is right.

# $back = true
# $lean_deg = 15.2
# $sigma_known = true
# $sigma_deg = 0.4
plane-not_plumb = The wall is not plumb: its points lean { $back ->
        [yes] back
        *[no] forward
    } by { NUM($lean_deg, digits: 2) }{ $sigma_known ->
        [yes] {" "}± { NUM($sigma_deg, digits: 2) }
        *[no] {""}
    } degrees.
    .why = The plane is plumb as requested.

# $wall = 3
# $n = 2
plane-no_such_wall = The points show { $n } { $n ->
        [one] wall
        *[other] walls
    }, not { $wall }.
    .do = Give a smaller { OPTION("wall") }, or name points of the wall: { OPTION("plane", "A,B,C") }.
