several_cameras = Kamera { $camera }: Die { $photographs } Aufnahmen gehören zu { $cameras } verschiedenen Kameras, Brennweiten oder Fokussierungen.
    .why = { $symbol } unterscheidet sich um { NUM($spread_px, digits: 2) } px, innerhalb einer Gruppe um { NUM($scatter_px, digits: 2) } px (p { NUM($p, digits: 1) }); Standardabweichungen sind zu klein.
    .do = Neu orientieren mit:

several_cameras-own = { OPTION("own_camera", $pattern) }
