# $x = 411000.0
# $y = 5300000.0
# $system = "EPSG:32633"
# $on_earth = true
# $longitude_deg = 2.5
# $latitude_deg = 47.8
# $longitudes_deg = [12.0, 18.0]
# $latitudes_deg = [0.0, 84.0]
# $hint = "system"
crs-outside_area = { NUM($x, decimals: 2) }, { NUM($y, decimals: 2) } are no coordinates of { $system }.
    .why = { $on_earth ->
        [yes] They would lie at longitude { NUM($longitude_deg, decimals: 2) }, latitude { NUM($latitude_deg, decimals: 2) }; its area of use is longitude { $longitudes_deg }, latitude { $latitudes_deg }
       *[no] No place on earth has these coordinates
     }.
    .do = { $hint ->
        [named] Give the system of the coordinates; omit { OPTION("crs") } for metres in local axes
        [named_exchanged] Interchange easting and northing, or give the system of the coordinates with { OPTION("crs") }
        [degrees] Give the system of the coordinates: they look like degrees or metres in local axes
        [exchanged] Write easting or longitude first, or correct the system
        [feet] Write metres: as feet they fit
       *[system] Give the system of the coordinates
     }.

# $x = 411000.0
# $y = 5300000.0
# $system = "WGS 84"
# $quantity = "longitude"
# $limit = 180.0
# $swapped = false
crs-beyond_circle = { NUM($x, decimals: 2) }, { NUM($y, decimals: 2) } is outside { $system }: { $quantity ->
        [latitude] latitude
       *[longitude] longitude
     } ends at { $limit }.
    .do = { $swapped ->
        [yes] Check whether longitude and latitude are interchanged
       *[no] Give the coordinate system of the grid, such as EPSG:32633
     }.

# $system = "EPSG:25832+ellipsoid"
crs-undulation_of_ellipsoid = { $system } already has ellipsoidal heights.
    .do = Omit { OPTION("undulation") }, or +ellipsoid in the name of the system.

# $own = "EPSG:25832"
# $system = "EPSG:31468"
crs-other_datum = { $own } and { $system } differ in more than the projection.
    .why = Datum or heights are different; such a transformation has an accuracy to be chosen.
    .do = Give a projection of the same datum, or transform the result with ogr2ogr -t_srs.

crs-incomplete = The coordinate system is incomplete.
    .do = Give crs = "EPSG:..." and origin = [east, north, height].

# $heights = "DHHN2016 height"
# $kind = "known"
# $grid = "de_bkg_gcg2016.tif"
# $folder = "/usr/share/proj"
# $ellipsoidal = "EPSG:25832+ellipsoid"
crs-geoid_missing = { $heights } needs a geoid that is not installed.
    .why = Without it, heights would be wrong by up to 100 m.
    .do = { $kind ->
        [known] Run pyproj sync --file { $grid }, or copy https://cdn.proj.org/{ $grid } to { $folder }
        [own] Correct the path of the grid { $grid }
       *[unknown] Add the undulation to all heights ({ OPTION("undulation", "METRES") } of convert and rpc), and give { $ellipsoidal }
     }.

# $shape = [4, 2]
crs-coordinate_shape = Coordinates of shape (n, 3) are needed, not ({ $shape }).
    .do = Give an array with three columns: X, Y and Z.

# $number = 3
# $x = 411.0
# $y = 48.2
# $system = "EPSG:25832"
crs-not_transformed = Point { $number } at { NUM($x, decimals: 2) }, { NUM($y, decimals: 2) } is outside { $system }.
    .do = Check the coordinate system and the order of the coordinates (easting or longitude first).

# $text = "'EPSG:1'"
crs-unknown = { $text } is not a known coordinate system.
    .do = Give EPSG:CODE, a PROJ string or WKT.

# $text = "'+5773'"
# $ellipsoid = "+ellipsoid"
crs-heights_of_proj_string = { $text } after a PROJ string is not supported.
    .do = Give the plan system as EPSG:CODE, or ellipsoidal heights as { $ellipsoid }.

# $zone = 61
crs-utm_zone = UTM zone { $zone } is not between 1 and 60.
    .do = Correct the zone.

# $text = "'EPSG:5773'"
crs-not_on_earth = { $text } has no position on the earth.
    .do = Give a projected, geographic or geocentric system.

# $system = "EPSG:25832+7837"
# $ellipsoid = "+ellipsoid"
crs-heights_twice = { $system } already defines its heights.
    .do = Omit { $ellipsoid }.

# $x = 534684.0
# $y = 5338120.0
# $system = "EPSG:4326"
crs-no_local_frame = { NUM($x, digits: 10) }, { NUM($y, digits: 10) } has no local frame in { $system }.
    .do = Check coordinates and coordinate system.

crs-origin_height_unknown = The height of the origin is unknown; 0 is assumed.

# $system = "EPSG:32633"
# $unit = "metre"
# $undulation_m = 46.0
# $older = false
crs-heights_above_geoid = Vertical datum: not defined by { $system }; heights in { $unit } above a geoid at { $undulation_m } m{ $older ->
     [yes] { "" } (WGS 84)
     *[no] { "" }
    } assumed.

# $system = "EPSG:32633"
# $unit = "metre"
# $coded = true
# $code_name = "EPSG:32633"
# $ellipsoidal = "EPSG:32633+ellipsoid"
# $sea = "EPSG:32633+5773"
crs-heights_assumed = Vertical datum: not defined by { $system }; ellipsoidal heights in { $unit } assumed.
    .do = { $coded ->
     [yes] Name the system { $ellipsoidal } if this is right, or with the vertical system, such as { $sea } (EGM96)
     *[no] Write { $ellipsoidal } after the system if this is right; add the height of the geoid to heights above the sea ({ OPTION("undulation") } of convert and rpc)
    }.

# $heights = "EGM96 height"
# $undulation_m = 46.0
# $older = false
crs-undulation_added = { $heights }: heights above the geoid; a constant undulation of { $undulation_m } m is added{ $older ->
     [yes] { "" } (WGS 84)
     *[no] { "" }
    }.

# $table = "control.csv"
# $x = 534684.0
# $y = 5338120.0
# $system = "EPSG:32633"
# $longitude_deg = 9.5
# $latitude_deg = 48.2
# $exchanged = false
crs-outside_use = { $table }: { NUM($x, digits: 10) }, { NUM($y, digits: 10) } is outside the area of use of { $system }.
    .why = The place is at longitude { NUM($longitude_deg, decimals: 2) }°, latitude { NUM($latitude_deg, decimals: 2) }°.
    .do = { $exchanged ->
     [yes] Check whether eastings and northings are exchanged
     *[no] Check the coordinate system
    }.

crs-needed_by_settings = { OPTION("frame_origin") } and { OPTION("undulation") } need a coordinate system.
    .do = Give { OPTION("crs") }.

# $system = "WGS 84"
crs-not_projected = { $system } is not a projected coordinate system.
    .why = A drawing has a scale only in a projected system.
    .do = Use a projected system, such as UTM.

# $system = "EPSG:25832+7837"
crs-plane_needed = { OPTION("crs", $system) } is not a plane coordinate system; a map needs one.
    .do = Give a plane or geographic system without heights.
