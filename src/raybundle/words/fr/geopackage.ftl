geopackage-not_written = Le GeoPackage n'a pas pu être écrit ({ $detail }).

geopackage-other_unit = La bibliothèque GeoPackage remplace { $system } par { $written }, d'une autre unité.
