photograph_list-rules = Regeln

photograph_list-taken = aufgenommen: { $name }

photograph_list-view = { $view ->
        [above] von oben (Y nach oben)
        *[front] von vorn (Z nach oben)
    }, 1 : { $scale }

photograph_list-in_other_sketch = { $n } weitere in der anderen Skizze

photograph_list-title = { $assistant }: { $name }

photograph_list-photographs = { $n } { $n ->
        [one] Aufnahme
        *[other] Aufnahmen
    }

photograph_list-table_head = { $name ->
        [target] Zielmarke
        [dot] Punkt, mm
        [code] Code, mm
        *[photographs] Aufnahmen
    }

photograph_list-stand = Standpunkt X { NUM($x, decimals: 2) }; Y { NUM($y, decimals: 2) } m, { NUM($height, decimals: 2) } m hoch.

photograph_list-aim = Abstand zum Objekt { NUM($distance, decimals: 2) } m, { NUM($tilt_deg, decimals: 0) } Grad nach { $up ->
        [yes] oben
        *[no] unten
    }.

photograph_list-turned = Kamera { NUM($turn_deg, decimals: 0) } Grad { $clockwise ->
        [yes] im
        *[no] gegen den
    } Uhrzeigersinn gedreht.

photograph_list-held = { $landscape ->
        [yes] Querformat
        *[no] Hochformat
    }{ $turn ->
        [0] {""}
        [180] , Kamera auf dem Kopf
        [90] , Kamera 90 Grad gegen den Uhrzeigersinn gedreht
        *[other] , Kamera 90 Grad im Uhrzeigersinn gedreht
    }.

photograph_list-camera = Kamera { $width_px } x { $height_px } px zu { NUM($pixel_um) } µm, c = { NUM($c_mm, digits: 4) } mm, f/{ NUM($f_number) }.

photograph_list-focus = Fokussiert auf { NUM($focus_m) } m.

photograph_list-sharp = Scharf ab { NUM($near_m) } m{ $far_m ->
        [0] {""}
        *[other] {" "}bis { NUM($far_m) } m
    }.

photograph_list-promise = Erwartete Standardabweichung einer Koordinate, mit { NUM($sigma_px) } px der Bildpunkte: größte { NUM($worst_mm, digits: 2) } mm, Mittel { NUM($mean_mm, digits: 2) } mm.

photograph_list-unseen = { PERCENT($share) } % des Objekts ist in weniger als zwei Aufnahmen (etwa Dach oder Oberseite).

photograph_list-calibration = Damit kalibriert: Bildpunkte auf schlimmstenfalls { NUM($sigma_px, digits: 2) } px über das Format (Standardabweichung).
    .why = Erwarteter Fehler dort { NUM($likely_px, digits: 2) } px; mit { PERCENT($sure) } % höchstens { NUM($sure_px, digits: 2) } px.

photograph_list-use = { $grade ->
        [good] Gut: in anderen Arbeiten mit Zielmarken festhalten.
        [usable] Brauchbar: für natürliche Punkte festhalten; Zielmarken verlangen { NUM($limit_px) } px.
        *[weak] Schwach: für diese Aufnahmen allein, Näherung für andere ({ NUM($limit_px) } px gefordert).
    }

photograph_list-reach = Bildpunkte reichen bis { PERCENT($share) } % des Wegs zu den Ecken.

photograph_list-ticked = Liste von { $n } Aufnahmen: { $oriented } orientiert; { $missing } fehlen, { $beside } neben der Liste.

photograph_list-missing = Es fehlt { $number }: { $text }

photograph_list-named = { $kind ->
        [doubled] Mehrfach aufgenommen
        [rolled] Kamera anders gehalten als gelistet
        [beside] Neben der Liste
        *[not_oriented] Nicht orientiert
    }: { $names }.
