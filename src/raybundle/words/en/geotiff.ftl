# $detail = "unknown driver"
geotiff-not_written = The GeoTIFF could not be written ({ $detail }).
    .do = Check free space and write permission of the folder, then run the command again.
