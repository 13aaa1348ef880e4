

photograph_list-rules = Regeln

photograph_list-taken = aufgenommen: { $name }

photograph_list-view = { $view ->
        [above] von oben (Y nach oben)
        *[front] von vorn (Z nach oben)
    }, 1 : { $scale }

photograph_list-in_other_sketch = { $n } weitere in der anderen Skizze

photograph_list-title = { $assistant ->
        [calibration] Kalibrieraufnahmen
        [cipa] CIPA-Aufnahmen
        [turntable] Drehtelleraufnahmen
        *[targets] Aufnahmen von Zielmarken
    }: { $name }

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

photograph_list-title_taken = { $title }: { $n } von { $of } aufgenommen

photograph_list-missing = { $n ->
        [0] Fehlend: keine
        *[other] Fehlend: { LIST($names, most: 1000) }
    }

photograph_list-convergent = 1 konvergent, volles Format

photograph_list-square = 2 senkrecht, Blatt in den Ecken

photograph_list-farther = 3 aus größerem Abstand

photograph_list-whole_sheet = Ganzes Blatt aus der Richtung { $azimuth_deg } Grad.

photograph_list-sheet_in_corner = Blatt in einer anderen Ecke des Formats.

photograph_list-sheet_from = Blatt von { $side ->
        [front] vorn
        [right] rechts
        [back] hinten
        *[left] links
    }.

photograph_list-rule_fixed_lens = Stellen Sie Zoom, Fokus und Blende einmal ein und kleben Sie sie fest. Schalten Sie Autofokus, Stabilisierung und automatische Drehung aus.

photograph_list-rule_sheet = Das Blatt füllt das Format bei { NUM($distance_m, decimals: 2) } m. Es ist eben. Bewegen Sie die Kamera, oder drehen Sie statt ihrer das Blatt.

photograph_list-rule_every_corner = In allen Aufnahmen zusammen muss jeder Teil des Formats Zielmarken zeigen, auch die Ecken.

photograph_list-rule_light = Sorgen Sie für Licht für eine kurze Belichtung, oder nehmen Sie ein Stativ. Vermeiden Sie Reflexe.

photograph_list-sharp_limits = Scharf von { NUM($near_m, decimals: 2) } bis { NUM($far_m, decimals: 2) } m; das Blatt reicht von { NUM($first_m, decimals: 2) } bis { NUM($last_m, decimals: 2) } m.

photograph_list-stop_down = Blenden Sie auf f/{ $f_number } ab und fokussieren Sie auf { NUM($focus_m, decimals: 2) } m.
    .do = Oder nehmen Sie ein größeres Blatt aus größerem Abstand, oder ungenauere, unscharfe Zielmarken.

photograph_list-larger_sheet = Ganz scharf ist es erst bei f/{ $needed }, was kaum ein Objektiv hat. Scharf ist ein { NUM($times, decimals: 1) }-mal so großes Blatt.
    .why = { NUM($width_m, decimals: 2) } x { NUM($height_m, decimals: 2) } m aus { NUM($distance_m, decimals: 2) } m, fokussiert auf { NUM($focus_m, decimals: 2) } m, bei f/{ NUM($f_number, decimals: 0) }.

photograph_list-blurred_sheet = Mit diesem Blatt ist f/{ NUM($f_number, decimals: 0) }, fokussiert auf { NUM($focus_m, decimals: 2) } m, von { NUM($near_m, decimals: 2) } bis { NUM($far_m, decimals: 2) } m scharf.
    .why = Zielmarken an seinen Enden sind um { NUM($blur_px, decimals: 1) } px verwischt (scharf: { $sharp_px } px): ungenauer, und verloren, wo Punkte kaum größer sind.

photograph_list-above_table = Kamera { $elevation_deg } Grad über dem Teller

photograph_list-table_turned = Teller auf { NUM($turn_deg, decimals: 0) } Grad gedreht.

photograph_list-rule_turntable = Die Kamera steht { NUM($distance_m, decimals: 2) } m vor der Mitte des Objekts; nur ihre Höhe ändert sich.

photograph_list-rule_background = Zeigen Sie nur das Objekt und seinen Teller: ein fester Hintergrund widerspricht dem Rest.
    .do = Nehmen Sie einen einfarbigen, oder Masken.

photograph_list-rule_even_light = Zielmarken oder Textur auf dem Teller drehen sich mit und dürfen gemessen werden.
    .do = Nehmen Sie gleichmäßiges Licht, denn festes Licht wandert über sie.

photograph_list-rule_scale = Maßstab: eine Maßstabsstrecke oder zwei Zielmarken bekannten Abstands auf dem Teller.

photograph_list-targets_shown = Zielmarken: { LIST($names, most: 1000) }

photograph_list-rule_targets = { $n } Zielmarken, Codes 1 bis { $n }: Punkte von { NUM($dot_mm, decimals: 1) } mm, Codes von { NUM($code_mm, decimals: 0) } mm (die größten; die Tabelle nennt jede).

photograph_list-rule_bar = Maßstabsstrecke { $number }: { NUM($length_m, decimals: 3) } m zwischen { $start } und { $end }, Länge auf { NUM($sigma_mm, digits: 2) } mm oder besser bekannt.

photograph_list-rule_flat = Befestigen Sie Zielmarken eben, nicht über einer Kante und nicht von einer anderen verdeckt.
    .why = Die Orte dürfen um einen Teil des Abstands der Zielmarken abweichen.

photograph_list-cipa_control = 1 Passelemente: lange Strecken zwischen guten Punkten, mindestens eine auf jeder Seite.
    .why = Lote und waagrechte Linien.

photograph_list-cipa_ring = 2 Ring: Aufnahmen rundum, die sich um mehr als die Hälfte überdecken.
    .why = Aufnahmen über jede Ecke unter 45 Grad.

photograph_list-cipa_details = 3 Einzelheiten: senkrechte Stereopaare jeder Fassade, Basis zu Abstand 1:4 bis 1:15.
    .why = Schmuck noch näher.

photograph_list-cipa_camera = 4 Kamera: eine Kamera, ein Objektiv; Zoom und Fokus fest, keine selbsttätige Änderung des Bildes.

photograph_list-cipa_calibration = 5 Kalibrierung: ein vorher oder mit diesen Aufnahmen kalibriertes Objektiv.
    .why = Das weitwinkligste gute; beides notieren.

photograph_list-cipa_exposure = 6 Belichtung: gleichmäßiges Licht, kleine Blende, geringe Empfindlichkeit, im Dunkeln ein Stativ.
    .why = Rohdaten oder beste Qualität.

photograph_list-cipa_sketch = 7 Skizze: ein Grundriss mit den Standpunkten und der Nordrichtung, eine Ansicht jeder Seite.

photograph_list-cipa_protocol = 8 Protokoll: Eigentümer, Ort, Datum, Wetter, Kamera und Objektiv, Fotograf, die Strecken der Regel 1.

photograph_list-cipa_check = 9 Prüfung: vor Ort alles durchsehen, scharf und vollständig; vor der Abreise eine Kopie machen.

photograph_list-side = { $number ->
        [0] { $side ->
            [front] Vorderseite
            [right] rechte Seite
            [back] Rückseite
            *[left] linke Seite
        }
        *[other] Seite { $number } ({ $side ->
            [front] vorn
            [right] rechts
            [back] hinten
            *[left] links
        })
    }{ $more ->
        [yes] ,
        *[no] {""}
    }

photograph_list-along = { NUM($at_m, decimals: 1) } m vom linken Ende, Boden bis oben

photograph_list-ring = Ring:

photograph_list-corners = Ring: Ecken

photograph_list-over_corner = Über eine Ecke, { NUM($turn_deg, decimals: 0) } Grad neben der ersten Seite:

photograph_list-stereo_pair = Stereopaar:

photograph_list-pair = Paar { $number } von { $of }, { $left ->
        [yes] linke
        *[no] rechte
    } Aufnahme, Hochformat, beide gleich

photograph_list-distances = Ring: { NUM($ring_m, decimals: 1) } m vor den Wänden, { NUM($eye_m, decimals: 1) } m hoch; Paare aus { NUM($pairs_m, decimals: 1) } m, Basis { NUM($base_m, decimals: 2) } m.

photograph_list-clearance = Keine Aufnahme näher als { NUM($distance_m) } m.

photograph_list-ticked = Liste von { $n } Aufnahmen: { $oriented } orientiert; { $missing } fehlen, { $beside } neben der Liste.

photograph_list-named = { $kind ->
        [doubled] Mehrfach aufgenommen
        [rolled] Kamera anders gehalten als gelistet
        [beside] Neben der Liste
        *[not_oriented] Nicht orientiert
    }: { $names }.

photograph_list-not_taken = Es fehlt { $number }: { $text }
