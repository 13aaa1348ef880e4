report_control-title = Passpunkte, Kontrollpunkte und Gruppen von Beobachtungen

report_control-none = Passpunkte, Kontrollpunkte, Maßstabsstrecken und Projektionszentren wurden nicht angegeben.

report_control-kind = { $kind ->
        [control] Passpunkte
        [distance] Maßstabsstrecken
        [station] Beobachtete Projektionszentren
        [attitude] Beobachtete Drehungen
        [parameter] Beobachtete Parameter
        [relation] Beziehungen zwischen Parametern, Glattheit von Trajektorien
        [deviation] Innere Orientierung einzelner Bilder, Abweichungen von ihrer Kamera
        [coordinate] Koordinaten von Netzen, mit ihrer Kovarianz
        [direction] Horizontalrichtungen
        [zenith_angle] Zenitwinkel
        [slope_distance] Schrägstrecken
        [difference] Koordinatendifferenzen
        [plane] Punkte auf Ebenen
        [line] Punkte auf Geraden
        [plumb_line] Punkte auf Lotrechten
        [level] Punkte in Höhenlagen
        *[other] { $title }
    }

report_control-object = { $kind ->
        [control] Punkt
        [coordinate] Punkt
        [distance] von–nach
        [direction] von–nach
        [zenith_angle] von–nach
        [slope_distance] von–nach
        [difference] von–nach
        [station] Bild
        [attitude] Bild
        [parameter] Kamera
        [relation] Kamera
        [deviation] Kamera/Bild
        [plane] Ebene: Punkt
        [line] Gerade: Punkt
        [plumb_line] Lotrechte: Punkt
        [level] Höhenlage: Punkt
        *[other] { $what }
    }

report_control-all_rows = { report_control-kind }, alle { $n } Zeilen

report_control-leave_one_out = Kreuzvalidierung: ausgeglichen minus gegeben, wenn der Punkt mit allen Koordinaten nicht teilgenommen hätte.

report_control-first_order = In erster Ordnung berechnet.

report_control-no_check_points = Es gibt keine Kontrollpunkte; diese Differenzen ersetzen sie.

report_control-points_left_out = Kreuzvalidierung, je Passpunkt

report_control-coordinate_left_out = Kreuzvalidierung einer Koordinate, mit den anderen ihres Punktes: Verbesserung durch Redundanzanteil.
    .why = Sie zeigt eine einzelne falsche Koordinate. Als Genauigkeit ist sie zu günstig, wo Koordinaten eines Punktes einander stützen.

report_control-coordinates_left_out = Kreuzvalidierung, je Koordinate

report_control-asprs = Genauigkeit nach ASPRS (2024), einschließlich der Genauigkeit der Kontrollpunkte.

report_control-rmse = { $name } = { $rmse } { $unit ->
        [units] Einheiten
        *[other] { $unit }
    } aus { $n } { $n ->
        [one] Kontrollpunkt
        *[other] Kontrollpunkten
    }.

report_control-check_sigma_missing = Kontrollpunkte ohne eigene Standardabweichung zählen mit 0.

report_control-check_points_needed = ASPRS verlangt mindestens { $least } Kontrollpunkte; mit weniger ist dies kein Nachweis der Genauigkeit.

report_control-marks = { $n } { $n ->
        [one] Messung
        *[other] Messungen
    } von Passpunkten (rot) und Kontrollpunkten (grün) in { $images } { $images ->
        [one] Bild
        *[other] Bildern
    }.

report_control-marks_vectors = Vektoren: Verbesserungen, ausgeglichen minus gemessen; ein Kreuz: verworfen.

report_control-marks_drawn = Gezeichnet: die { $n } von { $of } Bildern mit den meisten Messungen.

report_control-marks_heading = Messungen in den Bildern

report_control-held = { $n } { $n ->
        [one] Koordinate ist
        *[other] Koordinaten sind
    } wie gegeben festgehalten, ohne Verbesserungen.

report_control-held_list = Festgehaltene Koordinaten

report_control-observed = { $n } { $n ->
        [one] Wert
        *[other] Werte
    } beobachtet, { $held } festgehalten.

report_control-rms_by_sigma = Verbesserung durch σ: RMS { NUM($rms, decimals: 2) }.

report_control-largest_w = Größtes |w|: { NUM($w, decimals: 2) }.

report_control-rms_residual = Verbesserungen: RMS { $rms } { $unit ->
        [units] Einheiten
        *[other] { $unit }
    }, größte { $largest } { $unit ->
        [units] Einheiten
        *[other] { $unit }
    }.

report_control-uncontrolled = Alle sind für das Datum nötig; keine andere Beobachtung kontrolliert sie.

report_control-largest_rows = Die größten |w|

report_control-known_before = vorher bekannt: { $symbol }

report_control-logarithms = Beobachtet ist der natürliche Logarithmus von { $symbols } in mm, wovon ein Faktor vorher bekannt war.
    .why = σ und Verbesserung sind relativ: 0,01 ist etwa 1 %.

report_control-residual_note = Verbesserung: ausgeglichen minus gegeben.

report_control-marked = Hervorgehoben: |w| über seinem kritischen Wert für alle Tests zusammen.

report_control-difference_note = d: ausgeglichen minus gegeben.

report_control-rejected_control = Diese Punkte widersprechen den anderen: Sie sind weder Pass- noch Kontrollpunkte.

report_control-rejected_heading = Verworfene Passpunkte

report_control-largest_ratio = größtes |d| / σ

report_control-check_sigma_note = Ihr σ enthält das der ausgeglichenen und das der gegebenen Koordinate.

report_control-all_check_points = Alle { $n } { $n ->
        [one] Kontrollpunkt
        *[other] Kontrollpunkte
    }

report_control-check_points = Kontrollpunkte

report_control-rms_ratio = RMS von d / σ

report_control-group_differs = weicht von den anderen ab (1 %)

report_control-group_note = Eine hervorgehobene Gruppe weicht von allen anderen zusammen ab (F-Test, Förstner 1979).
    .why = Ihr Gewicht ist zu hoch, wenn ihr Verhältnis über dem der anderen liegt, sonst zu niedrig.
    .do = Ihre Standardabweichung a priori ändern.

report_control-images_differ = { $n } { $n ->
        [one] Bild weicht
        *[other] Bilder weichen
    } ebenfalls ab: siehe die Bilder unter „Verbesserungen“.

report_control-components = Varianzkomponenten

report_control-component_kind = { $kind ->
        [image_observations] Bildbeobachtungen
        [camera] Kamera
        [point_class] Punktklasse
        [attitudes] Drehungen
        [stations] Projektionszentren
        [distances] Strecken
        [directions] Richtungen
        [zenith_angles] Zenitwinkel
        [slope_distances] Schrägstrecken
        [coordinate_differences] Koordinatendifferenzen
        [parameters] Parameter
        [relations] Beziehungen
        [control] Passpunkte
        [deviations_of_single_images] Abweichungen einzelner Bilder
        [planes] Ebenen
        [straight_lines] gerade Linien
        [plumb_lines] Lotlinien
        [levels] Höhengleiche
        [coordinates_of_networks] Netzkoordinaten
        *[other] { $other }
    }

report_control-component_group = { $name ->
        [all] alle
        [tie_points] Verknüpfungspunkte
        [targets] Zielmarken
        [control_points] Passpunkte
        [check_points] Kontrollpunkte
        *[other] { $other }
    }

report_control-origin = X, Y, Z sind lokal: Ost, Nord, oben.
    .why = Ihr Ursprung in { $system } ist { $degrees ->
        [yes] { NUM($x, decimals: 7) }; { NUM($y, decimals: 7) }; { NUM($z, decimals: 3) }
       *[no] { NUM($x, decimals: 3) }; { NUM($y, decimals: 3) }; { NUM($z, decimals: 3) }
    }.
