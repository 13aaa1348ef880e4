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
