# $parts = ["NITF", "WV02", "35170 x 23708 px"]
scene-file = Scene: { $parts }.

# $n = 12
# $which = "image"
scene-points = { $n } { $which ->
        [ground] ground
        *[image] image
    } { $n ->
        [one] point
        *[other] points
    } computed.

# $n = 400
# $x = 0.01
# $y = 0.02
# $largest = 0.08
scene-fitted = RPC fitted: rms { $x }, { $y } px at { $n } independent points, largest { $largest } px.

# $low = 0.0
# $high = 400.0
# $strength = 1e-6
scene-fit_heights = Heights { $low } to { $high } m, regularisation { $strength }.

# $longitude = 8.12345
# $latitude = 48.12345
# $low = 100.0
# $high = 900.0
scene-rpc = RPC: centre { NUM($longitude, decimals: 5) } E, { NUM($latitude, decimals: 5) } N, heights { NUM($low, decimals: 0) } to { NUM($high, decimals: 0) } m.

# $x = 0.5
# $y = 0.6
scene-pixel = Pixel on the ground: { $x } m in x, { $y } m in y.

# $bias_m = 5.0
# $x = 8.1
# $y = 8.3
scene-stated_bias = Stated bias: { $bias_m } m (68 %), { $x }, { $y } px.

# $seconds = 3.2
# $height = 500.0
scene-rigorous = Rigorous model: { NUM($seconds, digits: 4) } s, corners at height { $height } m.

# $x = 35170.0
# $y = 0.0
# $known = true
# $longitude = 8.123456
# $latitude = 48.123456
scene-corner = Corner { NUM($x, decimals: 0) }, { NUM($y, decimals: 0) }: { $known ->
        [yes] { NUM($longitude, decimals: 6) } E, { NUM($latitude, decimals: 6) } N
        *[no] looks past the body
    }

# $x = 0.012
# $y = -0.03
# $std_x = 0.02
# $std_y = 0.03
scene-agreement = Rigorous model minus RPC: mean { $x }, { $y } px, standard deviation { $std_x }, { $std_y } px.
    .why = Over the scene and 80 % of the heights.

# $width = 4000
# $height = 3000
# $pixel = 0.5
# $crs = "EPSG:32633"
# $share = 0.97
# $nodata = 0.0
scene-ortho = Orthophoto: { $width } x { $height } px of { $pixel } in { $crs }, { PERCENT($share, digits: 3) } % seen (no data: { $nodata }).

# $n = 3
# $of = 4
scene-corrected = Corrected: { $n } of { $of } { $of ->
        [one] scene
        *[other] scenes
    }.
