geotiff-not_written = Das GeoTIFF konnte nicht geschrieben werden ({ $detail }).
