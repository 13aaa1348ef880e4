camera_joined = Kamera { $camera }: { $n } von { $photographs } Aufnahmen ({ $width_px } x { $height_px } px) haben dieselbe innere Orientierung.
    .why = Diese Aufnahmen sind { $turned ->
        [yes] um { $turn_deg }° im Uhrzeigersinn gedreht gespeichert (Chi-Quadrat { NUM($chi_square, decimals: 1) } bei { $dof }; { NUM($other_chi_square, decimals: 1) } für die andere Drehung)
       *[no] anders groß (Chi-Quadrat { NUM($chi_square, decimals: 1) } bei { $dof })
    }{ $reduced ->
        [yes] {" "}und verkleinert
       *[no] {""}
    }; Kamera { $other } wurde vereinigt.

camera_joined-doubtful = Kamera { $camera }: Die Drehung von { $n } von { $photographs } Aufnahmen ({ $width_px } x { $height_px } px) ist mehrdeutig.
    .why = Angenommen: um { $turn_deg }° im Uhrzeigersinn gedreht gespeichert{ $reduced ->
        [yes] {" "}und verkleinert
       *[no] {""}
    }, Kamera { $other } vereinigt (Chi-Quadrat { NUM($chi_square, decimals: 1) } bei { $dof }; { NUM($other_chi_square, decimals: 1) } für die andere Drehung, die den Bildhauptpunkt verschöbe).
    .do = Die Dateien so angeben, wie die Kamera sie speicherte.

camera_joined-gimbal = { $n } { $n ->
        [one] Aufnahme ist
       *[other] Aufnahmen sind
    } gegenüber den anderen { $others } kopfstehend gespeichert: { LIST($ids, most: 3) }.
    .why = Die Gimbalwinkel passen dazu, und eine Kamera passt nach einer Drehung um 180° besser (Chi-Quadrat um { NUM($gain, decimals: 0) } kleiner).

camera_joined-half_turned = { $n } Aufnahmen ({ $first } bis { $last }) sind gegenüber den anderen { $others } kopfstehend gespeichert.
    .why = Nach einer Drehung um 180° passt dieselbe Kamera zu allen (Chi-Quadrat um { NUM($gain, decimals: 0) } kleiner); Metadaten zur Bestätigung fehlen.
