terrain-flight_beyond = Der Flug reicht bis { NUM($x, decimals: 1) }; { NUM($y, decimals: 1) }, über das Höhenraster hinaus.
    .why = Das Raster umfasst X { NUM($low_x, decimals: 1) } bis { NUM($high_x, decimals: 1) }, Y { NUM($low_y, decimals: 1) } bis { NUM($high_y, decimals: 1) }.
    .do = Ein Höhenraster angeben, das Gebiet, Rand und Startplatz umfasst.

terrain-void_below_flight = Das Höhenraster hat keine Höhe bei { NUM($x, decimals: 1) }; { NUM($y, decimals: 1) } unter dem Flug ({ $n } solche Stellen).
    .do = Die Lücken des Rasters füllen oder ein anderes angeben.
