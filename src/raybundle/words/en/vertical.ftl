# $way = "'sideways'"
vertical-unknown_way = { OPTION("up") } is { $way }.
    .do = Give auto, terrestrial, aerial, oblique, or two points A,B of { OPTION("control") }, B plumb above A.

# $point = "B"
vertical-point_without_place = { OPTION("up") }: point { $point } has no coordinates.
    .do = Measure it in two photographs ({ OPTION("control") }).

# $first = "A"
# $second = "B"
vertical-same_place = { OPTION("up") }: points { $first } and { $second } are at the same place.
    .do = Give two points, the second plumb above the first.

# $way = "lines"
vertical-no_plumb_line = { OPTION("up", $way) }: the block has no measured plumb line with two points.
    .do = Measure a plumb line, or give { OPTION("up", "A,B") } with B vertically above A.

# $way = "y"
vertical-way_unknown = { OPTION("up", $way) } is not possible.
    .do = Give z, lines, or two points A,B with B vertically above A.

# $way = "A,B"
vertical-points_coincide = { OPTION("up", $way) }: the points are at the same place.
    .do = Give two points that are apart.
