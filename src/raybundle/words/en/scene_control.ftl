# $unit = "foot"
# $factor = 0.3048
# $shift_px = 120.0
# $rms_px = 8.1
# $shift_then_px = 3.0
# $rms_then_px = 0.7
scene_control-height_unit = Control heights seem to be in { $unit }, not in metres.
    .why = Image shift { $shift_px } px and residuals { NUM($rms_px, digits: 2) } px become { $shift_then_px } px and { NUM($rms_then_px, digits: 2) } px.
    .do = Give heights in metres ({ $unit } times { NUM($factor, digits: 10) }).

# $share = 0.4
# $limit = 0.05
# $model = "affine"
# $cause = "exchanged"
# $rms_px = 1.2
scene_control-image_axes = Control points turn or stretch the image by { PERCENT($share) } % with bias { $model } (limit { PERCENT($limit) } %).
    .why = { $cause ->
        [none] Such an error is impossible in an RPC.
       *[other] Such an error is impossible in an RPC. With the correction below, the points fit to { $rms_px } px.
     }
    .do = { $cause ->
        [exchanged] Exchange x_px and y_px
        [x] Count x_px from the left edge
        [y] Count y_px from the upper edge
        [corner] Count x_px and y_px from the upper left corner
       *[none] Check that points and scene belong together, and the order of x_px and y_px
     }.

# $scene = "scene_1.tif"
# $others = ["scene_2.tif"]
scene_control-other_images = The file contains no image point of scene { $scene }.
    .do = Correct the names of images in it; they are { LIST($others, most: 5) }.

# $columns = ["lon_deg", "lat_deg", "h_m"]
scene_control-geographic_columns = Columns { $columns } are WGS 84 with ellipsoidal heights, in no other system.
    .do = Omit { OPTION("crs") } and { OPTION("undulation") }, or rename the columns to X, Y, Z.

# $table = "points.csv"
scene_control-image_points_twice = The file has image points of its own; { $table } cannot be added.
    .do = Omit { OPTION("image_points") }, or delete the columns x_px, y_px.

# $columns = ["image", "point", "x_px", "y_px"]
scene_control-no_image_point = The control has no image points.
    .do = Add columns x_px, y_px, or give a table { LIST($columns, most: 6) } as { OPTION("image_points", "FILE.csv") }.

scene_control-no_point = The file contains no point.
    .do = Check that it is the right file.

# $point = "P1"
scene_control-point_twice = Point { $point } occurs twice.
    .do = Delete one, or give it another name.

# $point = "P1"
# $table = "control.csv"
scene_control-point_missing = Point { $point } is missing in { $table }.
    .do = Add it there, or correct its name.

# $name = "x_px"
# $value = "'abc'"
scene_control-attribute_not_a_number = Attribute { $name }: { $value } is not a number.
    .do = Give a number.

# $names = ["name", "Z"]
# $n = 2
# $columns = ["image", "point", "x_px", "y_px"]
scene_control-no_image_attributes = The point has no attributes x_px and y_px.
    .why = { $n ->
     [0] It has no attributes.
     *[other] Its attributes are { LIST($names, most: 12) }.
    }
    .do = Add them, or give a table { LIST($columns, most: 6) } as { OPTION("image_points", "FILE.csv") }.

# $kind = "'Polygon'"
scene_control-not_a_point = The geometry is { $kind }, not Point.
    .do = Save the control as points.

# $n = 1
scene_control-coordinate_count = Coordinates of the point: { $n }; needed: 2 or 3.
    .do = Give longitude, latitude and height.

# $points = true
# $columns = ["image", "point", "x_px", "y_px"]
scene_control-no_layer = The file has no layer with { $points ->
     [yes] points
     *[no] columns { LIST($columns, most: 6) }
    }.
    .do = Check that it is the right file.

# $n = 2
# $total = 10
# $point = "P1"
scene_control-no_height = { $n } of { $total } points have no height; the first is { $point }.
    .why = An RPC needs a height of every point.
    .do = Add a column Z, or save points with three coordinates.

# $own = "WGS 84"
# $system = "ETRS89"
scene_control-other_system = The control is in { $own }, { OPTION("crs") } is { $system }.
    .do = Omit { OPTION("crs") }, or give the system of the file with its heights.

# $point = "P1"
# $x = 534684.0
# $y = 5338120.0
scene_control-not_degrees = Point { $point } ({ NUM($x, digits: 10) }, { NUM($y, digits: 10) }) is not in degrees, and no coordinate system is defined.
    .do = Give { OPTION("crs", "EPSG:CODE") }.

scene_control-not_points = The geometry of this row is not a point.
    .do = Save the control as points.

# $name = "control.csv"
# $image = "scene_2.tif"
# $scene = "scene_1.tif"
scene_control-image_assumed = The image points of { $name } are of { $image }; they are used for { $scene }.

scene_control-wgs84_assumed = Coordinate system of the control: not defined; WGS 84 with ellipsoidal heights assumed.
    .do = Give { OPTION("crs", "EPSG:CODE") } if it is another one.

# $header = ["point", "x_px"]
# $geographic = ["point", "lon_deg", "lat_deg", "h_m", "x_px", "y_px"]
# $grid = ["point", "X", "Y", "Z", "x_px", "y_px"]
# $image_points = ["image", "point", "x_px", "y_px"]
scene_control-columns_missing = The columns { LIST($header, most: 12) } do not make a table of control.
    .why = Needed are { LIST($geographic, most: 9) }, or { LIST($grid, most: 9) }.
    .do = Add the missing columns, or give a table { LIST($image_points, most: 9) } as { OPTION("image_points", "FILE.csv") }.

scene_control-check_only = All points are check points.
    .do = Make at least one of them control.

# $n = 12
scene_control-image_missing = There are { $n } scenes, but points do not name the image in which they are measured.
    .do = Add a column image.
