picture-rectified = Entzerrt: { $width } x { $height } px zu { $pixel } { $unit }, { PERCENT($share) } % bedeckt aus { $n } { $n ->
        [one] Aufnahme
        *[other] Aufnahmen
    }.

picture-plane = { $kind ->
        [plumb] Lotrechte Ebene
        [vertical] Vertikale Ebene
        [horizontal] Waagrechte Ebene
        *[other] Ebene
    } durch { $n } von { $of } Punkten{ $kind ->
        [plumb] {""}
        *[other] ; RMS der Abstände { NUM($rms, digits: 2) } { $unit }
    }.

picture-displacement = Versatz durch Relief: das { NUM($slope, digits: 2) }-Fache des Abstands von der Ebene (RMS; höchstens { NUM($largest, digits: 2) }).

picture-lean = Neigung der Punkte: { $lean } (Lotrichtung: { $vertical }).

picture-level = Höhe der Ebene: { NUM($height, decimals: 2) }.

picture-sigma0 = sigma0 { NUM($sigma0, digits: 2) } (Marken a priori { $sigma_px } px), Redundanz { $redundancy }.

picture-points_off_plane = Abstand der Passpunkte von ihrer Ebene: { NUM($rms, digits: 2) } (RMS).

picture-differences = Gemessene minus gegebene Koordinaten:
