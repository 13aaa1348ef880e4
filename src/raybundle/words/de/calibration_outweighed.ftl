calibration_outweighed = Kamera { $camera }: Das Ergebnis bestimmt sie ungenauer als die angegebene Kalibrierung (Grenze { NUM($limit, digits: 2) }-mal).
    .why = Die Beobachtungen sind wie bei unabhängigen Fehlern gewichtet und ziehen die Kamera von besser bekannten Werten weg.
    .do = Die Kalibrierung festhalten (estimate = []).

calibration_outweighed-parameter = Parameter { $symbol }: Standardabweichung { NUM($before, digits: 2) } wie angegeben, { NUM($after, digits: 2) } im Ergebnis.
