calibration_outweighed = Kamera { $camera }: Das Ergebnis bestimmt sie ungenauer als die angegebene Kalibrierung (Grenze { NUM($limit, digits: 2) }-mal).
    .why = Die Beobachtungen sind wie bei unabhängigen Fehlern gewichtet und ziehen die Kamera von besser bekannten Werten weg.
    .do = Die Kalibrierung festhalten (estimate = []).

calibration_outweighed-parameter = { $symbol }: Standardabweichung vorher { NUM($before, digits: 2) }, jetzt { NUM($after, digits: 2) }
