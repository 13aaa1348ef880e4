geopackage-not_written = Das GeoPackage konnte nicht geschrieben werden ({ $detail }).
