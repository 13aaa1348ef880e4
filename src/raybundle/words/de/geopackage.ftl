geopackage-not_written = Das GeoPackage konnte nicht geschrieben werden ({ $detail }).
    .do = Freien Speicherplatz und Schreibrecht des Ordners prüfen oder ein anderes Format schreiben.

geopackage-other_unit = Die GeoPackage-Bibliothek ersetzt { $system } durch { $written } mit anderer Einheit.
    .do = Ein System in Metern angeben, etwa { OPTION("crs", "EPSG:32632") }.
