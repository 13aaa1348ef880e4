displacement-points = { $moved ->
        [0] Keiner von { $n } gemeinsamen Punkten verschoben
        *[other] { $moved } von { $n } gemeinsamen Punkten verschoben: { $names }
    } (Irrtumswahrscheinlichkeit { PERCENT($error_rate) } %).

displacement-level_of_detection = Nachweisgrenze (Testgüte 80 %): { NUM($median_mm, digits: 2) } mm (Median), { NUM($largest_mm, digits: 2) } mm (größte).

displacement-no_level_of_detection = Manche Verschiebungen sind nicht nachweisbar: zu wenige Punkte sind stabil.

displacement-tests = Kongruenz aller Punkte F = { $F } ({ P($p) }), der stabilen F = { $F_stable } ({ P($p_stable) }).

displacement-by_place = { $n } { $n ->
        [one] Punkt ist
        *[other] Punkte sind
    } über den Ort identifiziert, nicht über den Namen.
    .why = Ein Punkt, der sich um mehr als den halben Abstand verschiebt, gilt als ein anderer.

displacement-axes = Achsen X, Y, Z: die von { $file_name }, eingepasst über { $points }.

displacement-unsure = { $n } { $n ->
    [one] Gebiet ist
    *[other] Gebiete sind
 } keine sichere Bewegung: das Mittel des inneren Teils ist kleiner als { $limit } Standardabweichungen.
    .why = Fehler an Kanten und in gefüllten Lücken gelten für das ganze Gebiet; ein Fenster enthält nur die benachbarten.

displacement-one_date = Alle Fotos sind vom { $date }: keine Verschiebungen.
    .do = Fotos eines weiteren Tages mit { OPTION("add", "PHOTOS") } hinzufügen.

displacement-dates = { LIST($dates, most: 4) }: { $moved ->
        [0] keiner von { $points } Punkten verschoben
        *[other] { $moved } von { $points } Punkten verschoben: { LIST($names, most: 5) }
    }, { $areas ->
        [0] kein Gebiet
        [one] 1 Gebiet
        *[other] { $areas } Gebiete
    } verschoben (Irrtumswahrscheinlichkeit { PERCENT($error_rate) } %).

displacement-largest = Größte Verschiebung: { $point }, { NUM($length_mm, digits: 3) } mm ± { NUM($sigma_mm, digits: 2) } mm von { $start } bis { $end }.

displacement-area = { $name } ({ $n } Punkte): mittlere Verschiebung { NUM($length_mm, digits: 3) } mm ± { NUM($sigma_mm, digits: 2) } mm bis { $end }.

displacement-area_uneven = { $name } ({ $n } Punkte): ungleichmäßige Verschiebung, { NUM($shortest_mm, digits: 2) } mm bis { NUM($longest_mm, digits: 3) } mm bis { $end }.

displacement-changes = { $n } frühere Verschiebungen: geändert um { NUM($median, digits: 2) } Standardabweichungen (Median), { NUM($largest, digits: 2) } (größte, { $point }).
    .why = { $changed } { $changed ->
        [one] Punkt änderte
        *[other] Punkte änderten
    } sich um mehr als eine Standardabweichung. Anderes Urteil: { LIST($verdicts, most: 5) }. Ohne Gegenstück: { $missing }.

displacement-dates_changed = Daten geändert: aus { LIST($before, most: 5) } wurde { LIST($now, most: 5) }.
    .why = Frühere Verschiebungen werden nach ihren Fotos verglichen.

displacement-not_compared = Von { $n } früheren Verschiebungen ist keine vergleichbar: Daten oder Punkte haben sich geändert.

displacement-untested = { $n } { $n ->
        [one] verschobener Punkt ist
        *[other] verschobene Punkte sind
    } nicht prüfbar: { LIST($names, most: 5) }.
    .why = Ein falscher Bildpunkt erklärt die Verschiebung ebenso.
    .do = Mehr Fotos von jedem Tag aufnehmen.

displacement-velocity = Am schnellsten: { $name }, { NUM($speed_mm, digits: 3) } mm ± { NUM($sigma_mm, digits: 2) } mm im Jahr, { $verdict ->
        [constant] gleichförmig
        [accelerated] beschleunigt
        [decelerated] verzögert
       *[irregular] ungleichförmig
    } ({ $other } von { $n } Bewegungen sind nicht gleichförmig).
