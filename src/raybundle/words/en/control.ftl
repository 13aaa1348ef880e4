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
