stations-no_crs = Standpunkte in Landeskoordinaten brauchen das Koordinatensystem des Blocks.
    .do = { OPTION("crs", "EPSG:25832") } angeben.
