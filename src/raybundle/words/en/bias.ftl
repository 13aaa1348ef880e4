# $name = "'cubic'"
# $known = ["shift", "affine"]
bias-unknown_model = Bias model { $name } is unknown.
    .do = Use one of { LIST($known, most: 9) }.

# $ground = 4
# $image = 3
bias-point_count = { $ground } ground points and { $image } image points are given.
    .do = Give at least one pair of each.

# $model = "shift"
# $advised = "affine"
# $better = true
# $x_px = 12.5
# $y_px = 30.2
# $misfit = 25.0
# $limit = 10.0
# $sigma_px = 1.0
bias-misfit = The control points do not fit the RPC with bias { $model }: rms { $x_px } px in x, { $y_px } px in y.
    .why = That is { $misfit } times their standard deviation of { $sigma_px } px (limit { $limit }).
    .do = { $better ->
        [yes] Use bias { $advised }
       *[no] Check that points and scene belong together
     }, and check that heights are ellipsoidal and pixels count from the outer corner.

# $n = 2
# $model = "affine"
bias-not_determined = { $n } { $n ->
        [one] point does
       *[other] points do
     } not determine the bias { $model }.
    .do = Add points, or choose another bias.
