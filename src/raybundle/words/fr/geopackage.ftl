geopackage-not_written = Le GeoPackage n'a pas pu être écrit ({ $detail }).
