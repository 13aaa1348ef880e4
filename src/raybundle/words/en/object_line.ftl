# $name = "ring"
object_line-too_few_points = Object { $name }: its line has fewer than two points of two coordinates.
    .do = Give at least two points X,Y.

# $name = "ring"
# $point = 3
object_line-not_finite = Object { $name }: point { $point } of its line has a coordinate that is not a finite number.
    .do = Correct the coordinate, or delete this point from the line.

# $name = "ring"
# $first = 3
# $second = 4
object_line-identical_points = Object { $name }: points { $first } and { $second } of its line are identical.
    .do = Delete one of them.

# $name = "wall"
# $length_m = 2000000.0
# $largest_m = 1000000.0
object_line-too_long = Object { $name }: its line is { $length_m } m long, more than { $largest_m } m.
    .do = Check the unit of the coordinates.
