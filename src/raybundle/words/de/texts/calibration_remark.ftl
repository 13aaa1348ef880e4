calibration_remark-covariance_of_other_model = Die Kovarianz wird nicht übertragen: Sie gehört zu Parametern eines anderen Modells.

calibration_remark-no_correlations = Die Korrelationen werden nicht geschrieben: Das Format enthält nur Standardabweichungen.

calibration_remark-no_covariance = Die Kovarianz wird nicht geschrieben: Das Format enthält keine.

calibration_remark-nominal_pixel = Die Pixelgröße ist nominell: { $side_mm } mm entlang der längeren Seite. Ergebnisse in px hängen nicht davon ab.

calibration_remark-file_without_correlations = Die Datei enthält Standardabweichungen, aber keine Korrelationen.

calibration_remark-valid_radius = MicMac gibt einen gültigen Radius von { NUM($radius_px, decimals: 0) } px an.

calibration_remark-inputs_not_read = Die Eingaben der Optimierung von mrcal werden nicht gelesen; die Kovarianz ist daher unbekannt.

calibration_remark-no_distortion = Die Datei enthält keine Koeffizienten der Verzeichnung; 0 wird angenommen.

calibration_remark-skew = Die Scherung { $skew } der Matrix entfällt, weil die Funktionen von OpenCV sie nicht beachten.

calibration_remark-principal_point = Der Bildhauptpunkt { NUM($x_px, digits: 6) }; { NUM($y_px, digits: 6) } px liegt nicht nahe der Mitte des Formats, { $width_px } x { $height_px } px.
    .do = { $another_size ->
        [yes] Prüfen, ob die Matrix zu Bildern von { $other_width_px } x { $other_height_px } px gehört.
        *[no] {""}
    }

calibration_remark-fitted = Kamera { $camera } ist angepasst: größte Abweichung { NUM($largest_px, digits: 2) } px.

calibration_remark-of_stored = Kamera { $camera } gehört zu { $n } { $n ->
        [one] Foto, gespeichert
        *[other] Fotos, gespeichert
    } { $turned_deg ->
        [0] mit { $width_px } x { $height_px } px
        *[other] um { $turned_deg }° gedreht
    } ({ $images }).
    .do = Kamera { $other } nur dann dafür verwenden, wenn die Pixel zuvor in ihr Bildsystem gebracht werden.

calibration_remark-not_of_stored = Kamera { $other } gehört nicht zu { $n } { $n ->
        [one] Foto, gespeichert
        *[other] Fotos, gespeichert
    } { $turned_deg ->
        [0] mit { $width_px } x { $height_px } px
        *[other] um { $turned_deg }° gedreht
    } ({ $images }):

calibration_remark-scaled = { $name } hat { $width_px } x { $height_px } px und wird im Maßstab von { $other_width_px } x { $other_height_px } px verglichen.

calibration_remark-not_good_enough = Kamera { $camera } wird nicht in der Kamerabibliothek gespeichert: Ihre Kalibrierung ist { $grade ->
        [not_determinable] nicht bestimmbar
        [weak] schwach
        *[other] { $grade }
    }.

calibration_remark-not_stored = Kamera { $camera } wird nicht in der Kamerabibliothek gespeichert:
