quantity-coincide = The points coincide.
    .do = Choose other points.

quantity-in_line = The points are on one line.
    .do = Choose other points.

# $quantity = "plane"
# $names = ["A", "B", "C"]
quantity-not_defined = Quantity { $quantity } is not defined by the points { $names }.
    .do = Choose other points for this quantity.

# $quantity = "angle"
# $n = 2
# $least = 3
# $most = 3
quantity-point_count = { $quantity }: { $n } points are given; { $most ->
        [0] at least { $least } are needed
       *[other] { $least } to { $most } are possible
     }.
    .do = Give another number of points.

# $known = ["distance", "angle"]
quantity-none = No quantity is requested.
    .do = Give one of { LIST($known, most: 20) }.
