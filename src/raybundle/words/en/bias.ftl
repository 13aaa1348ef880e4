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

# $n = 1
# $total = 10
bias-points_excluded = { $n } of { $total } points { $n ->
        [one] is
        *[other] are
    } excluded.

# $model = "shift"
# $test = "F"
# $value = 42.0
# $limit = 7.2
# $few = false
# $left_out_px = 0.12
# $before_px = 3.4
bias-improvement = Bias { $model } improves the fit significantly: { $test } { $value } exceeds { $limit }.
    .why = { $few ->
        [yes] There are too few points to leave one out.
       *[no] Points left out are predicted within { $left_out_px } px (before: { $before_px } px).
     }
    .do = Use bias { $model }.

# $larger = true
# $misfit = 12.0
# $sigma_px = 0.3
bias-rpc_contradicted = No bias is advised: { $larger ->
        [yes] no larger model fits significantly better
        *[no] no larger model is possible
    }, but the points contradict the RPC.
    .why = The residuals are { $misfit } times the sigma of { $sigma_px } px; positions by this RPC are wrong by as much.
    .do = Check the points, the coordinate system and the heights, or add points for a larger model.

# $sigma_px = 0.3
bias-rpc_confirmed = No bias is needed: the RPC agrees with the points within the sigma of { $sigma_px } px.
    .do = Use the RPC without correction.
