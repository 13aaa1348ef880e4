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

picture-before_plane = { PERCENT($share) } % des Bildes zeigen Objekte vor der Ebene, die im Bild versetzt sind.
    .why = Diese, etwa Bäume oder eine andere Wand, sind um mehr als { PERCENT($distance_share) } % der Entfernung näher, und kein Foto blickt an ihnen vorbei.
    .do = Sie durch einen kleineren { OPTION("extent") } ausschließen oder Fotos mit { OPTION("only") } wählen.

picture-axes_given = Das Bild hat die angegebenen Achsen, nicht die der Karte.

picture-local_plane = { $system } ist kein projiziertes System; das Bild liegt in der lokalen Ebene des Blocks, Ost nach rechts.

picture-in_map = Das Bild liegt in { $system }.
