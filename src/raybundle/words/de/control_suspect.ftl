control_suspect = { $n ->
        [one] Passpunkt { $point } widerspricht
       *[other] { $n } Passpunkte widersprechen
     } den übrigen Beobachtungen{ $n ->
        [one] { "" }
       *[other] : { $ids }
     }.
    .why = { $n ->
        [one] Dieser Passpunkt geht in die Ausgleichung ein und verfälscht
       *[other] Diese Passpunkte gehen in die Ausgleichung ein und verfälschen
     } das Ergebnis.
    .do = Koordinaten und Punktnummern in den Bildern prüfen.

control_suspect-point = { $point }: Die übrigen Beobachtungen verschieben ihn um { NUM($dx, digits: 3) }; { NUM($dy, digits: 3) }; { NUM($dz, digits: 3) } { $unit } (|w| { NUM($w, decimals: 1) }, Grenze { NUM($limit, decimals: 1) }).

control_suspect-swayed = { LIST($names, most: 10) } { $n ->
        [one] fällt
       *[other] fallen
     } nur deshalb im Test auf.

control_suspect-unexplained = Passpunkte und übrige Beobachtungen widersprechen einander, am meisten bei { $ids }.
    .why = Einzelne falsche Punkte erklären das nicht.
    .do = Namen, Achsen, Einheit und Koordinatensystem der Passpunkte prüfen oder ihnen größere Standardabweichungen geben.
