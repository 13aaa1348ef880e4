film-transformed = Film: { $scans } { $scans ->
        [one] Scan
        *[other] Scans
    } transformiert, RMS der Rahmenmarken höchstens { NUM($rms_um, digits: 2) } um, { $points } Bildpunkte.
