# $detail = "unknown driver"
geotiff-not_written = The GeoTIFF could not be written ({ $detail }).
