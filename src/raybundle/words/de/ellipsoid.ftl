ellipsoid-semi_axes = Ellipsoid: a = { NUM($a, digits: 12) } m und b = { NUM($b, digits: 12) } m sind keine Halbachsen.
    .do = a >= b > 0 in Metern angeben.
