camera_constant_unknown = Kamera { $name } ist nicht kalibriert: { $symbol } ist nur auf { PERCENT($share) } % bekannt (Grenze { PERCENT($limit) } %).
    .why = Die Form des Objekts ist ebenso unsicher.
    .do = Eine Kalibrierung angeben oder konvergente Aufnahmen mit Tiefe machen.
