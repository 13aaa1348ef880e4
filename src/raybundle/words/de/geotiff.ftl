geotiff-not_written = Das GeoTIFF konnte nicht geschrieben werden ({ $detail }).
    .do = Freien Speicherplatz und Schreibrecht des Ordners prüfen, dann den Befehl erneut ausführen.
