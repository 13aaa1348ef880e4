systematic_residuals = Mittlere Verbesserungen über dem Format weichen von null ab ({ $n ->
        [one] Kamera
       *[other] Kameras
     } { $ids }).
    .why = { $independent ->
        [yes] Das Kameramodell lässt einen systematischen Anteil, den die Standardabweichungen nicht enthalten; in wenigen Aufnahmen sehen Fehler einzelner Bilder ebenso aus.
       *[no] Das Kameramodell lässt in allen Bildern einen systematischen Anteil, den die Standardabweichungen nicht enthalten.
     }
    .do = Eine Kalibrierung angeben oder verkantete und konvergente Aufnahmen machen.

systematic_residuals-camera = Kamera { $camera }: { $cells } von { $tested } Zellen, { NUM($rms_px, digits: 2) } px rms ({ PERCENT($share) } % der Verbesserungen), höchstens { NUM($largest_px, digits: 2) } px.
