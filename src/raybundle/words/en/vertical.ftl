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
