# $detail = "unknown driver"
geopackage-not_written = The GeoPackage could not be written ({ $detail }).
    .do = Check free space and write permission of the folder, or write another format.

# $system = "UTM 32N in km"
# $written = "UTM 32N"
geopackage-other_unit = The GeoPackage library replaces { $system } by { $written }, which has another unit.
    .do = Give a system in metres, such as { OPTION("crs", "EPSG:32632") }.
