# $name = "area 2"
# $first = 1
# $second = 4
outline-crosses_itself = { $name } crosses itself at the sides from corners { $first } and { $second }.
    .do = List its corners in their order along the outline.

# $name = "area 2"
outline-no_area = { $name } encloses no area.
    .do = Give at least three corners that are not in one line.
