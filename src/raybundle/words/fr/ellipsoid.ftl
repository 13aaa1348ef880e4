ellipsoid-semi_axes = Ellipsoïde : a = { NUM($a, digits: 12) } m et b = { NUM($b, digits: 12) } m ne sont pas des demi-axes.
