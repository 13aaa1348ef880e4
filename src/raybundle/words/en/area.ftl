area-none = The file has no polygon, line or point.
    .do = Give a file with one of these.

# $n = 200000
# $most = 100000
area-too_many_points = The outline has { $n } points; at most { $most } are read.
    .do = Simplify it.

# $text = "'8.25;47.5'"
area-no_position = { $text } is not longitude,latitude.
    .do = Correct the file.

# $detail = "not recognized as a supported format"
area-not_readable = The file cannot be read as lines or areas ({ $detail }).
    .do = Save it as GeoJSON, KML or GeoPackage.

area-damaged = A geometry of the file is damaged.
    .do = Export it again.

# $latitude_deg = 86.2
area-no_utm = The area is at latitude { NUM($latitude_deg, decimals: 1) }°, beyond UTM.
    .do = Give a coordinate system in metres.

# $x = 411000.0
# $y = 5300000.0
area-not_degrees = { NUM($x, decimals: 2) }, { NUM($y, decimals: 2) } are not longitude and latitude in degrees.
    .do = Give the coordinate system of the area, and longitude before latitude.

# $x = 411.0
# $y = 48.2
# $system = "EPSG:25832"
area-outside_system = { NUM($x, decimals: 2) }, { NUM($y, decimals: 2) } is outside { $system }.
    .do = Check the coordinate system.
