film-transformed = Film: { $scans } { $scans ->
        [one] Scan
        *[other] Scans
    } transformiert, RMS der Rahmenmarken höchstens { NUM($rms_um, digits: 2) } um, { $points } Bildpunkte.

film-distortion_terms = K1 bis K{ $n } geben die Tabelle der Verzeichnung auf { NUM($largest_um, decimals: 2) } µm wieder.

film-principal_points_differ = Die Hauptpunkte weichen um { NUM($difference_um, decimals: 0) } µm voneinander ab.
    .why = Der Teil, den die äußere Orientierung nicht aufnimmt, beträgt in den Ecken höchstens { NUM($corner_um, decimals: 1) } µm.
