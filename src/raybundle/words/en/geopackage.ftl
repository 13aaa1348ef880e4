# $detail = "unknown driver"
geopackage-not_written = The GeoPackage could not be written ({ $detail }).
