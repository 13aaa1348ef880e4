

flight_check-no_positions = Keine der Aufnahmen hat eine Position.
    .do = Eine Datei mit Positionen angeben.

flight_check-other_place = Keine Aufnahme liegt dort, wo die Befliegung { $mission } eine plant; im Mittel sind es { NUM($away_m, decimals: 0) } m.
    .do = Prüfen, ob es der Plan dieses Flugs ist.

flight_check-no_crs = Die Mission hat lokale Koordinaten; Aufnahmen haben Positionen auf der Erde.
    .do = Die Mission in einem Koordinatensystem planen: { OPTION("crs", "EPSG:CODE") }.

flight_check-ground_of_plan = Der Plan folgte { $terrain }, das fehlt; seine geplanten Höhen bestimmen das Gelände.
    .do = Geben Sie das Raster an ({ OPTION("dem") }).

flight_check-some_unplaced = { $n } von { $of } Aufnahmen haben keine Position ({ $example }, ...); sie zählen nicht.

flight_check-not_decoded = { $n } { $n ->
        [one] Aufnahme ist
        *[other] Aufnahmen sind
    } nicht lesbar ({ $example }, ...).

flight_check-blurred = { $n } unscharfe { $n ->
        [one] Aufnahme zählt
        *[other] Aufnahmen zählen
    } nicht: { $names }.

flight_check-tilted = { $n } zu stark geneigte { $n ->
        [one] Aufnahme zählt
        *[other] Aufnahmen zählen
    } nicht: { $names }.
