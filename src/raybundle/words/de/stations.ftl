stations-no_crs = Standpunkte auf einer Karte brauchen das Koordinatensystem des Blocks.
    .do = { OPTION("crs", "EPSG:25832") } angeben.
