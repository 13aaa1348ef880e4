terrain-flight_beyond = Der Flug reicht bis { NUM($x, decimals: 1) }; { NUM($y, decimals: 1) }, über das Höhenraster hinaus.
    .why = Das Raster umfasst X { NUM($low_x, decimals: 1) } bis { NUM($high_x, decimals: 1) }, Y { NUM($low_y, decimals: 1) } bis { NUM($high_y, decimals: 1) }.
    .do = Ein Höhenraster angeben, das Gebiet, Rand und Startplatz umfasst.

terrain-void_below_flight = Das Höhenraster hat keine Höhe bei { NUM($x, decimals: 1) }; { NUM($y, decimals: 1) } unter dem Flug ({ $n } solche Stellen).
    .do = Die Lücken des Rasters füllen oder ein anderes angeben.

terrain-object_too_wide = { OPTION("largest", $largest) } ist mehr als die Hälfte der kürzeren Seite ({ NUM($side, digits: 4) }).
    .why = Zwischen solchen Objekten bleibt kein Boden.
    .do = Die Breite des größten Objekts auf dem Boden angeben.

terrain-object_below_cell = { OPTION("largest", $largest) } ist weniger als eine Zelle ({ NUM($cell, digits: 6) }).
    .why = So kleine Objekte sind nicht im Raster.
    .do = Die Breite des größten Objekts auf dem Boden angeben.

terrain-slope_too_large = { OPTION("slope", $slope) } steigt über eine Zelle um { $rise }; alle Höhen unterscheiden sich nur um { $range }.
    .why = Kein Objekt könnte sich vom Boden abheben.
    .do = Die Neigung des Bodens in Prozent angeben.

terrain-no_ground = Keine Zelle bleibt als Boden.
    .do = { OPTION("slope") } größer wählen.

terrain-spans_gaps = { PERCENT($share) } % dieses Geländes ist über Lücken interpoliert.
    .do = Wählen Sie ein kleineres { OPTION("largest") } oder eine größere { OPTION("slope") }.
