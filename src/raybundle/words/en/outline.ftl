# $name = "area 2"
# $first = 1
# $second = 4
outline-crosses_itself = { $name } crosses itself at the sides from corners { $first } and { $second }.
    .do = List its corners in their order along the outline.

# $name = "area 2"
outline-no_area = { $name } encloses no area.
    .do = Give at least three corners that are not in one line.

# $n = 3
outline-not_one = The file has { $n } lines and areas; exactly one is needed.
    .do = Give a file with one line or area.

# $text = "'1 2 3'"
outline-no_pair = { $text } is not a pair of numbers.
    .do = Write X and Y in each line.

outline-empty = The file contains no coordinates.
    .do = Write X and Y in each line.

outline-no_cell = The outline contains no cell of the surface.
    .do = Check its coordinates and their system.

# $n = 2
# $total = 40
outline-too_few_heights = { $n } of { $total } places along the outline have a height; too few for a plane.
    .do = Give the height of the base.

outline-overlap = Two of the outlines overlap.
    .do = Give separate areas, or one outline around all of them.

# $share = 0.12
# $limit = 0.001
# $left = 0.0
# $bottom = -20.0
# $right = 30.0
# $top = 0.0
outline-beyond_heights = { PERCENT($share, digits: 3) } % of the outline is beyond the height grid (limit { PERCENT($limit) } %).
    .why = The grid covers { NUM($left, digits: 8) } { NUM($bottom, digits: 8) } { NUM($right, digits: 8) } { NUM($top, digits: 8) }.
    .do = Give an outline within the grid.

# $left = 10.0
# $bottom = 5.0
# $right = 0.0
# $top = 20.0
outline-extent_empty = The extent { NUM($left, digits: 8) } { NUM($bottom, digits: 8) } { NUM($right, digits: 8) } { NUM($top, digits: 8) } is empty.
    .do = Give left, bottom, right and top, in this order.

# $name = "outline"
outline-option_empty = { OPTION($name) } is empty.
    .do = Give a file, or corners as X Y, X Y, ...

# $name = "outline"
# $given = "1 2 3, 4"
outline-neither_file_nor_corners = { OPTION($name, $given) } is neither a file nor a list of corners.
    .do = Write corners as X Y, X Y, ...: a blank between the numbers, a comma between the corners.

outline-no_area_in_file = The file has no area; lines and points enclose nothing.
    .do = Give a file with a polygon.

# $name = "outline"
# $given = "1 2, 3 4"
outline-too_few_corners = { OPTION($name, $given) } has fewer than three corners.
    .do = Give at least three corners X Y, X Y, X Y.

outline-no_line_in_file = The file has no line.
    .do = Give a file with a line.

# $name = "line"
# $given = "1 2"
outline-single_place = { OPTION($name, $given) } is a single place; a line needs two.
    .do = Give two corners or more.

# $given = "1 2, 1 2"
outline-line_without_length = Line { $given }: two successive places are identical, or it has only one.
    .do = Give successive places that differ.

# $system = "EPSG:25832"
outline-heights_in_no_map = The file is in { $system }; these heights are on a plane of the object, in no map.
    .do = Give coordinates of the plane as CSV or GeoJSON without a coordinate system.

# $x = 12.5
# $y = 3.0
# $hole = 1
outline-hole_outside = Hole { $hole } of the outline leaves its edge near { NUM($x, digits: 8) }, { NUM($y, digits: 8) }.
    .why = The enclosed area is ambiguous.
    .do = Give an area with all holes within its edge.

# $x = 12.5
# $y = 3.0
# $hole = 2
# $other = 1
outline-holes_overlap = Holes { $other } and { $hole } of the outline overlap near { NUM($x, digits: 8) }, { NUM($y, digits: 8) }.
    .why = The enclosed area is ambiguous.
    .do = Give an area with separate holes.

# $x = 12.5
# $y = 3.0
outline-only_holes = The holes of the outline cover all of it (near { NUM($x, digits: 8) }, { NUM($y, digits: 8) }).
    .do = Give an area with smaller holes.
