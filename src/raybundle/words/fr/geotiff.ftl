geotiff-not_written = Le GeoTIFF n'a pas pu être écrit ({ $detail }).
