length_test-no_length = Eine Längenprüfung braucht mindestens eine bekannte Länge.
    .do = Eine kalibrierte Länge zwischen zwei gemessenen Punkten angeben.

length_test-no_scale = { $name }: Keine Beobachtung bestimmt den Maßstab; Längen haben keine Einheit.
    .do = Eine Maßstabsstrecke angeben.

length_test-invalid_length = Länge { $start } - { $end }: { $length_m } m mit Standardabweichung { $sigma_m } m ist ungültig.
    .do = Eine Länge über 0 zwischen zwei verschiedenen Punkten und eine Standardabweichung von 0 oder mehr angeben.

length_test-no_error = Länge { $start } - { $end } hat keinen Fehler, da beide Enden festgehalten sind.
    .why = Eine solche Länge kann die Messung nicht prüfen.
    .do = Diese Länge weglassen.

length_test-same_ends = Länge { $start } - { $end }: Beide Enden sind derselbe Punkt.
    .do = Die Namen der Enden korrigieren.

length_test-ends_not_measured = Enden von { $bars ->
        [yes] Maßstabsstrecken
       *[no] bekannten Längen
     }, die nicht gemessen sind: { LIST($points, most: 10) }.
    .do = Die Namen korrigieren oder diese Punkte messen.

length_test-other_unit = Bekannte Längen sind { NUM($ratio, digits: 4) }-mal so lang wie die gemessenen.
    .why = Die Einheit der bekannten Längen oder der Maßstabsstrecken ist falsch{ $likely ->
        [yes] { " " }(vermutlich { $units })
       *[no] { "" }
     }.
    .do = Maßstabsstrecken in Metern angeben{ $table ->
        [yes] ; { OPTION("unit", 0.001) } liest Dateien in Millimetern
       *[no] { "" }
     }.
