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

# $kind = "linescan"
# $seconds = 3.2
# $height = 500.0
scene-rigorous = Rigorous model: { $kind ->
        [linescan] line scanner
        [push_frame] push-frame camera
        [frame] frame camera
        [optical_bar] optical-bar camera
        [range_doppler] radar
       *[other] { $kind }
    }{ $kind ->
        [frame] {""}
       *[other] {", "}{ NUM($seconds, digits: 4) } s
    }, corners at height { $height } m.

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

scene-no_common_ground = It shows no ground of another scene, and is not marked.

# $n = 4
# $needed = 8
scene-few_common_points = It has { $n } { $n ->
        [one] point
        *[other] points
    } in common with other scenes ({ $needed } are needed).

# $name = "control.csv"
# $system = "EPSG:32633"
# $given = true
scene-control_system = { $name }: taken in { $system }{ $given ->
        [yes] {""}
        *[no] {" "}(longitude, latitude, ellipsoidal height)
    }.

# $low_m = 1200.0
# $high_m = 1500.0
# $lowest_m = -100.0
# $highest_m = 900.0
scene-ground_outside_heights = The ground of the scene is { NUM($low_m, decimals: 0) } to { NUM($high_m, decimals: 0) } m above the ellipsoid.
    .why = The RPC is valid for heights of { NUM($lowest_m, digits: 6) } to { NUM($highest_m, digits: 6) } m.
    .do = Check the geoid and the unit of the heights.

# $height_m = 1200.0
# $lowest_m = -100.0
# $highest_m = 900.0
scene-height_outside = Height { NUM($height_m, digits: 6) } m; the RPC is valid for { NUM($lowest_m, digits: 6) } to { NUM($highest_m, digits: 6) } m.

scene-outside_area = Outside the area of the RPC.

# $x_px = 1200.5
# $y_px = -3.0
# $width_px = 1000
# $height_px = 1000
scene-outside_picture = x { NUM($x_px, decimals: 1) }, y { NUM($y_px, decimals: 1) } is outside the picture of { $width_px } x { $height_px } px.

scene-other_body = The body is not the earth; other programs will assume WGS 84 for this RPC.
