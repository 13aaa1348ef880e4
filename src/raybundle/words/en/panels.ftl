# $point = "G7"
panels-no_coordinates = Point { $point } has no given coordinates.
    .do = Give them: raybundle mark control FOLDER TABLE.csv.

panels-no_control = No control or check point has given coordinates.
    .do = Give them: raybundle mark control FOLDER TABLE.csv.

# $least = 3
panels-not_placed = Nothing places the block in the coordinate system of the control.
    .why = The search starts where the photographs should show each point.
    .do = Mark { $least } control points by hand and adjust, or orient with positions of the photographs: { OPTION("positions", "FILE") }.

# $n = 11
# $of = 12
# $marks = 78
panels-found = Panels found: { $n } of { $of } points, { $marks } new marks.

# $x = 1.41
# $y = -0.92
# $z = 2.31
# $unit = "m"
# $spread = 0.011
panels-shift = Block minus given coordinates: X { NUM($x, digits: 3) }, Y { NUM($y, digits: 3) }, Z { NUM($z, digits: 3) } { $unit } (median); the points scatter by { NUM($spread, digits: 2) } { $unit }.

# $why = "nothing"
# $names = ["G3", "G9"]
# $least = 3
panels-missed = Points without a panel: { LIST($names, most: 6) }. { $why ->
        [not_visible] No photograph shows their place.
        [nothing] Nothing stands out near their place.
        [few_rays] Fewer than { $least } photographs show a panel.
        [few_points] Fewer than { $least } points show a panel; one shift cannot be confirmed.
        [ambiguous] Several panels fit.
        [off] The nearest panel contradicts the other points.
        *[no_panel] The place cannot be measured as a cross, chequered square or disc.
    }
    .do = Mark by hand, or check the coordinates.

# $point = "G7"
# $distance = 1.73
# $unit = "m"
panels-off = { $point }: { NUM($distance, digits: 3) } { $unit } from its place.

panels-files_not_read = The control files of the project were not read.
    .why = Only points of the block and of marks were looked for.
    .do = Put the files back, or give the coordinates by raybundle mark control.

# $n = 2
# $names = ["a.jpg", "b.jpg"]
panels-photographs_lost = Photographs missing or not readable: { $n }, not searched ({ LIST($names, most: 6) }).
    .do = Put the photographs back, and search again.
