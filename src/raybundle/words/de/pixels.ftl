pixels-shape = Pixel müssen ein Feld der Dimension (n, 2) sein, nicht ({ $shape }).
    .do = Ein Feld mit zwei Spalten angeben: x und y.

pixels-distance = Die Entfernung { $distance } ist nicht größer als 0.
    .do = Eine Entfernung über 0 angeben, oder None für unendlich.
