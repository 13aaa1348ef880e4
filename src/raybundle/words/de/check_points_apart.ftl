check_points_apart = { $n } { $n ->
        [one] Kontrollpunkt weicht
       *[other] Kontrollpunkte weichen
     } stärker ab, als die Standardabweichungen zulassen (in { $axes }).
    .why = Die Standardabweichungen des Ergebnisses sind bis zur Klärung nicht verlässlich.
    .do = Koordinaten, Namen, Achsen, Einheit und Koordinatensystem der Kontrollpunkte prüfen, dann die Orientierung.

check_points_apart-axis = Koordinate { $axis }: Die Differenzen sind das { NUM($factor, digits: 2) }-Fache ihrer Standardabweichungen (Grenze { NUM($limit, digits: 2) }).

check_points_apart-point = Kontrollpunkt { $point } weicht um { NUM($factor, digits: 2) } Standardabweichungen in { $axis } ab (Grenze { NUM($limit, digits: 2) }).

check_points_apart-no_single_point = Kein einzelner Punkt fällt auf.
