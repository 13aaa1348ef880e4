pixels-shape = Pixel müssen ein Feld der Form (n, 2) sein, nicht ({ $shape }).

pixels-distance = Die Entfernung { $distance } ist nicht größer als 0.
    .do = Eine Entfernung über 0 angeben, oder None für unendlich.
