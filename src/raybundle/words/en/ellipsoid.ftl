# $a = 6378137.0
# $b = 7000000.0
ellipsoid-semi_axes = Ellipsoid: a = { NUM($a, digits: 12) } m and b = { NUM($b, digits: 12) } m are no semi-axes.
    .do = Give a >= b > 0 in metres.
