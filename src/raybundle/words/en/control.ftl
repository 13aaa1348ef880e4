# $measurements = "marks.csv"
control-own_measurements = The file has its own measurements; { $measurements } cannot be added.
    .do = Give a file of measurements only with a CSV of points.

# $point = "A1"
control-no_coordinate = Point { $point } has no coordinate.
    .do = Give one, or delete the line.

# $point = "A1"
control-normal = Point { $point }: nX, nY, nZ are incomplete or all 0.
    .do = Give the three components of one vector.

control-none_in_block = The block has neither control points nor check points.
    .do = Give a block with points of role control or check.

# $n = 4
# $names = ["A", "B", "C", "D"]
# $coordinates = ["534684", "5338120", "171"]
control-one_place = All { $n } control points have the same coordinates ({ LIST($coordinates, most: 3) }): { $names }.
    .why = Control in one place determines neither direction nor scale.
    .do = Give each point its own coordinates; a line was probably copied.

# $systems = ["EPSG:25832", "EPSG:25833"]
control-several_systems = The control is in different coordinate systems: { $systems }.
    .do = Convert it to one system.

# $n = 1
# $least = 2
control-too_few_measured = Control points with two or more rays: { $n }; at least { $least } are needed.
    .do = Measure more of them in the photographs, or give positions and a coordinate system of the control.

# $point = "P1"
# $table = "check.csv"
control-point_twice = Point { $point } is also in { $table }.
    .why = A point is either control or check.
    .do = Give one of them another name, or delete it.

# $names = ["DSC_1.jpg"]
# $photographs = ["IMG_1.jpg"]
control-other_photographs = None of the photographs in which the file measures points is in the set.
    .why = The file has { LIST($names, most: 3) }; the set has { LIST($photographs, most: 3) }.
    .do = Check that the file belongs to these photographs, and the names.

# $n = 4
# $points = ["A1", "A2", "A3", "A4"]
control-points_in_line = The { $n } measured control points lie in one line, or are one point: { LIST($points, most: 5) }.
    .do = Give a datum by three control points that are not in one line.

# $ratio = 1000.2
# $likely = true
# $units = "mm for m"
control-other_unit = The scale bars make the network { NUM($ratio, digits: 4) } times as large as the control.
    .why = The unit of one of them is wrong{ $likely ->
        [yes] { " " }(likely { $units })
       *[no] { "" }
     }.
    .do = Give the unit of the control file: { OPTION("unit") }.

# $photograph = "wall.jpg"
control-none_in_photograph = No point with X and Y is measured in { $photograph }.
    .do = Check that the image names agree.

# $n = 2
# $total = 8
control-too_few_for_datum = { $n } of { $total } points are measured control with X, Y and Z; a datum needs three.
    .do = Name control points by the codes of their targets.
