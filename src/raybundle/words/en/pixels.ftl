# $shape = [4, 3]
pixels-shape = Pixels must be an array of shape (n, 2), not ({ $shape }).
    .do = Give an array with two columns: x and y.

# $distance = -1.0
pixels-distance = The distance { $distance } is not above 0.
    .do = Give a distance above 0, or None for infinity.
