calibration-difference = Unterschied { $infinity ->
        [yes] im Unendlichen
        *[no] in der Entfernung { $distance }
    } nach einer Drehung um { NUM($turn_deg, decimals: 4) } Grad: RMS { $rms_px } px, größter { $largest_px } px.

calibration-expected = Nach den Kovarianzen zu erwarten: { $expected_px } px. Der Unterschied ist das { NUM($ratio, decimals: 1) }-Fache{ $same ->
        [yes] {""}
        *[no] : nicht eine Kamera in einem Zustand
    }.

calibration-parts = Größter Unterschied [px] in 3 x 3 Teilen des Formats:

calibration-converted = Kamera { $camera }: { $model }, { $exact ->
        [yes] genau
        *[no] über das Format angepasst, RMS { $rms_px } px, größte Abweichung { $largest_px } px
    }.

calibration-stored = In der Kamerabibliothek abgelegt: { $key }.

calibration-library = { $n } { $n ->
        [one] Kalibrierung
        *[other] Kalibrierungen
    } in { $folder }:

calibration-entry = { $key }; { $width_px } x { $height_px } px, { $model }; { $date }, { $source }{ $photographs ->
        [0] {""}
        [one] , 1 Aufnahme
        *[other] , { $photographs } Aufnahmen
    }{ $sigma0 ->
        [0] {""}
        *[other] , sigma0 { $sigma0 }
    }{ $grade ->
        [none] {""}
        *[other] , { $grade }
    }

calibration-photograph = { $name }: { $key }; { $width_px } x { $height_px } px.

calibration-match = { $fits ->
        [yes] passt
        *[no] nein
    }: { $name }: { $reasons }

calibration-completed = { $n } { $n ->
        [one] Zielmarke
        *[other] Zielmarken
    } durch Prädiktion ergänzt.

calibration-dots = { $n } { $n ->
        [one] Punkt
        *[other] Punkte
    } ohne Code.
