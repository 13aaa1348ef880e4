# $kind = "plumb line"
# $name = "L1"
# $n = 1
# $least = 2
# $table = "plumb_lines"
alignment-too_few_points = { $kind } { $name }: { $n } points at different places; { $least } are needed.
    .do = Add measured points, or delete its rows in { $table }.csv.
