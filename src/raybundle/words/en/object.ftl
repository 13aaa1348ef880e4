# $name = "sphere"
# $needs = "DIAMETER"
object-takes_no_line = Object { $name } takes no line of points.
    .do = Give { $needs }.

# $name = "box"
# $n = 2
# $needs = "LENGTH, WIDTH, HEIGHT"
object-number_count = Object { $name }: { $n } numbers are given.
    .do = Give { $needs }.

# $name = "sphere"
# $dimension = "diameter"
# $value_m = -1.0
# $largest_m = 1000000.0
object-dimension_out_of_range = Object { $name }: { $dimension } is { $value_m } m.
    .do = Give a value above 0 and at most { $largest_m } m.
