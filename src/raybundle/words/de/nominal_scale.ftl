nominal_scale = Soll- und Messpunkte unterscheiden sich im Maßstab um { $near_1 ->
        [yes] { NUM($scale_ppm, digits: 4) } ppm
       *[no] einen Faktor von { NUM($factor, digits: 6) }
     }.
    .why = Mit diesem Maßstabsfaktor passen sie auf { NUM($rms_mm, digits: 2) } mm (rms), ohne ihn auf { NUM($rms_same_scale_mm, digits: 2) } mm.
    .do = Die Einheit der Datei und die Maßstabsstrecken prüfen.
