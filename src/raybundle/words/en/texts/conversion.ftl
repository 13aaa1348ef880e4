# $cameras = ["left", "right"]
conversion-rigs = Cameras of a rig are written as single cameras: { LIST($cameras, most: 8) }.

# $camera = "1"
# $largest_px = 2.1
conversion-read_out = The format does not hold the read-out of camera { $camera }: image points move by up to { NUM($largest_px, digits: 2) } px.
    .why = They lie where they would be had all rows been read at one instant; the photographs are unchanged.

# $unit = "mm"
# $format = "BINGO"
conversion-in_metres = The block is in { $unit }; its coordinates are written in m, the unit of { $format }.

conversion-free_scale = The scale of the block is free, because no length fixes it: lengths in the file have no unit.

# $n = 2
# $total = 40
# $names = ["a.jpg", "b.jpg"]
conversion-not_oriented = { $n } of { $total } images are not oriented and are left out: { $names }.

# $n = 2
# $total = 400
# $names = ["P1", "P2"]
conversion-no_coordinates = { $n } of { $total } points have no coordinates and are left out: { $names }.

# $points = 35
# $observations = 153
conversion-not_held = The format has no place for { $points ->
        [0] {""}
        [one] { $points } point and{" "}
        *[other] { $points } points and{" "}
    }{ $observations } image { $observations ->
        [one] observation
        *[other] observations
    }; they are left out.

# $camera = "1"
# $model = "OPENCV"
# $largest_px = 0.02
conversion-camera_fitted = Camera { $camera } is written as { $model }, fitted over the format: largest deviation { $largest_px } px.

# $unit = "mm"
# $table = "cameras.toml"
conversion-measured_points = Image points are the measured ones, in { $unit } about the image centre.
    .why = Principal point and distortion stand in { $table } only.
    .do = Enter these in the other program, or remove distortion from the photographs first: { OPTION("undistort") }.

# $unit = "us-ft"
conversion-dxf_unit = DXF has no code for the unit { $unit }; the drawing states none.

# $heights = "US survey foot"
# $plan = "metre"
conversion-height_unit = Heights are in { $heights }, east and north in { $plan }, as in the coordinate system.

# $system = "EPSG:32633"
conversion-system = Coordinates are written in { $system }.

conversion-nerfstudio_images = nerfstudio expects the photographs in images/ beside the file.

conversion-kml_heights = Viewers show these ellipsoidal heights off by the geoid undulation.
    .why = Heights in KML refer to sea level.

# $unit = "m"
conversion-plane_axes = Coordinates are written in the axes of the plane{ $unit ->
        [none] {" (no unit)"}
        *[other] {" "}[{ $unit }]
    }: X to the right, Y up, Z out of it.
    .why = Their standard deviations neglect the correlations between the coordinates of the block.

# $unit = "m"
conversion-no_system = The block has no coordinate system; its own axes{ $unit ->
        [none] {" (no unit)"}
        *[other] {" "}[{ $unit }]
    } are written.
    .why = The file states that they are local.

# $n = 2
conversion-no_footprint = { $n } { $n ->
        [one] photograph has
        *[other] photographs have
    } no footprint: not all of it shows the ground from above.

# $name = "facade.prj"
# $tiff = true
conversion-system_beside = The coordinate system stands in { $name }, the position in the world file.
    .why = { $tiff ->
        [yes] rasterio, which writes GeoTIFF, is not installed.
        *[no] {""}
    }
    .do = { $tiff ->
        [yes] To write GeoTIFF, install it: pip install 'raybundle[geo]'
        *[no] {""}
    }

# $n = 120
conversion-outside_undistorted = { $n } image { $n ->
        [one] observation lies
        *[other] observations lie
    } outside the undistorted images and { $n ->
        [one] is
        *[other] are
    } left out.

# $name = "a.jpg"
conversion-photograph_left_out = { $name } is left out:

# $name = "a.jpg"
conversion-no_colours = { $name } gives no colours:

# $name = "a_RPC.TXT"
# $low_m = 100.0
# $high_m = 900.0
# $largest_px = 0.01
conversion-new_rpc = { $name }: a new RPC for heights of { NUM($low_m, decimals: 0) } to { NUM($high_m, decimals: 0) } m, with deviations up to { NUM($largest_px, digits: 2) } px.

# $system = "EPSG:32633"
# $x = 500000.0
# $y = 5400000.0
# $z = 120.0
conversion-local_frame = The block is transformed from { $system } to a local east-north-up frame.
    .why = Its origin is { NUM($x, decimals: 3) }, { NUM($y, decimals: 3) }, { NUM($z, decimals: 3) }.

# $scenes = "a, b"
conversion-scenes_without_stations = Of satellite scenes ({ $scenes }) the points are written; their stations, 600 km up, are not.

# $scenes = "a, b"
conversion-scenes_nominal_stations = Satellite scenes ({ $scenes }) give points; their stations are nominal viewpoints, 600 km up.

# $scenes = "a, b"
conversion-no_scenes = Satellite scenes are left out: { $scenes }.

# $n = 12
# $least = 2
conversion-few_rays = { $n } tie { $n ->
        [one] point is
        *[other] points are
    } left out: fewer than { $least } image observations each.

# $n = 12
conversion-rejected_observations = { $n } rejected image { $n ->
        [one] observation is
        *[other] observations are
    } left out.

# $n = 12
conversion-rejected_points = { $n } tie { $n ->
        [one] point is
        *[other] points are
    } left out: all their image observations are rejected.
