# $plane = "facade.toml"
# $world = "facade.jgw"
picture-no_scale = The scale of the picture is unknown: { $plane } and { $world } are missing beside it.
    .do = Rectify the photograph first, or add one of these files.

# $picture = "EPSG:25832"
# $block = "EPSG:25833"
picture-other_system = The picture is in { $picture }, the block in { $block ->
        [none] its own axes
        *[other] { $block }
    }.
    .do = Transform the block: { OPTION("crs", "EPSG:25832") }.

# $photograph = "img_07"
# $offset = 0.12
# $pixel = 0.005
# $unit = "m"
picture-earlier_adjustment = The picture belongs to an earlier adjustment: photograph { $photograph } has moved by { $offset } { $unit }.
    .why = Points of this adjustment do not fit the picture (pixel { $pixel } { $unit }).
    .do = Rectify again.

# $known = [".jpg", ".tif"]
picture-suffix = The name of the picture has another ending than { LIST($known, most: 8) }.
    .do = Give a name with one of these endings.

# $detail = "Permission denied"
picture-not_geotiff = The picture cannot be written as GeoTIFF ({ $detail }).
    .do = Give a raster that GDAL reads, or write NAME_RPC.TXT, NAME.RPB or NAME.geom.

picture-free_scale = The scale of this picture is not determined; a drawing needs one.
    .do = Give the adjustment a scale bar, two control points or observed positions, and rectify again.

# $missing = "south.toml"
picture-world_file_only = A world file does not define the position of the plane in space.
    .why = Points of a block cannot be drawn on this picture.
    .do = Add { $missing }, which rectify writes.

picture-no_plane_points = A single photograph needs points of the plane.
    .do = Give { OPTION("control", "FILE") }.

# $setting = "plane"
# $result = true
picture-setting_of_other_source = { OPTION($setting) } belongs to { $result ->
        [yes] a result
       *[no] a single photograph
     }.
    .do = Leave it out{ $result ->
        [yes] ; a photograph has { OPTION("control") }
       *[no] ; a result has the calibration and orientation already
     }.

# $detail = "image file is truncated"
picture-not_readable = The picture cannot be read ({ $detail }).
    .do = Write the picture again.

# $width = 0.0
# $height = 5.0
# $pixel = 0.01
picture-area_empty = An area of { $width } x { $height } with a pixel of { $pixel } makes no picture.
    .do = Give an area and a pixel above 0.

# $width = 8.0
# $height = 5.0
# $pixel = 10.0
# $setting = "pixel"
picture-pixel_too_large = A pixel of { $pixel } is larger than the area of { NUM($width, digits: 4) } x { NUM($height, digits: 4) }.
    .do = Give a smaller { OPTION($setting) }.

# $width_px = 80000
# $height_px = 90000
# $limit_px = 1000000000.0
# $setting = "pixel"
# $needed = 0.02
picture-too_large = The picture would have { $width_px } x { $height_px } px (limit { $limit_px } px).
    .do = Give { OPTION($setting, $needed) }, or a smaller { OPTION("extent") }.

# $setting = "extent"
# $system = "EPSG:25832"
# $west = 0.0
# $east = 10.0
# $south = 0.0
# $north = 20.0
# $block_west = 534684.0
# $block_east = 534760.0
# $block_south = 5338120.0
# $block_north = 5338200.0
picture-area_far_away = { OPTION($setting) } is far away from the points of the result.
    .why = It is east { NUM($west, digits: 10) } to { NUM($east, digits: 10) }, north { NUM($south, digits: 10) } to { NUM($north, digits: 10) }; the points are within { NUM($block_west, decimals: 0) } to { NUM($block_east, decimals: 0) }, { NUM($block_south, decimals: 0) } to { NUM($block_north, decimals: 0) }.
    .do = Give map coordinates ({ $system }).

picture-no_photograph = No photograph shows the area, or none was read.
    .do = Give the folder of the photographs ({ OPTION("photos") }), or another { OPTION("extent") }.

# $exception = "P4"
# $limit = 0.01
# $alone = true
picture-control_on_line = The control points are on one straight line (limit { PERCENT($limit) } % of its length).
    .why = { $alone ->
        [yes] Only { $exception } is beside the line, so nothing beside it can be checked
       *[no] The picture beside the line is not determined
    }.
    .do = Measure points all around the area of the picture.

picture-area_not_shown = The photograph does not show the area.
    .do = Give another { OPTION("extent") }.

picture-hidden_places = Places hidden by steep slopes or buildings are not detected.
    .why = Such a place may appear twice in the picture.

# $share = 0.3
picture-few_points_in_plane = { PERCENT($share) } % of the points lie in this plane.
    .why = Most of the picture is displaced.
    .do = Choose the wall with { OPTION("plane") }.

# $off = 0.02
# $unit = "m"
# $pixels = 4.0
picture-points_displaced = Points are displaced in the picture by { NUM($off, digits: 2) } { $unit } ({ NUM($pixels, digits: 2) } px, rms) since they lie off the plane.
    .do = Measure in the photographs what must be more accurate.

# $x = 4.2
# $y = 3.1
# $sigma0 = 8.0
# $worst = "C3"
picture-residuals = Residuals of { NUM($x, digits: 3) }, { NUM($y, digits: 3) } px (rms) are { NUM($sigma0, digits: 3) } times as large as expected; largest: { $worst }.
    .why = A mark or coordinate is wrong, names are exchanged, a point is off the plane, or the lens distorts.
    .do = Check { $worst }, or use a calibrated camera.

picture-no_redundancy = The picture rests on as many points as it needs: errors are not noticed.
    .do = Add one point.

picture-mirrored = The picture is mirrored.
    .why = The control points run the other way round in the photograph than in the plane.
    .do = Check left and right, the signs of the axes, and the side of the film.

# $share = 0.34
# $limit_share = 0.05
# $limit = 0.015
# $displacement = 0.21
# $back = -0.35
# $front = 0.62
# $unit = "m"
picture-relief = Relief displaces { PERCENT($share) } % of the wall's points by more than { NUM($limit, digits: 2) } { $unit } (limit { PERCENT($limit_share) } %).
    .why = The wall reaches from { NUM($back, digits: 2) } to { NUM($front, digits: 2) } { $unit } about the plane; a picture of one plane shifts or doubles it by { NUM($displacement, digits: 2) } { $unit }.
    .do = Draw it with raybundle facade, or accept the displacement: { OPTION("relief", "LENGTH") }.
