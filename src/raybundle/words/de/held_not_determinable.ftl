held_not_determinable-cameras = Die Punkte bestimmen die innere Orientierung von { $ids } nicht; die Näherungswerte werden festgehalten.
    .why = Standardabweichungen gelten nur für diese Werte.
    .do = Mehr Punkte messen.

held_not_determinable = Kamera { $camera }: { $symbol } ist nicht bestimmbar und auf dem bekannten Wert { NUM($at, digits: 4) } { $unit } festgehalten.
    .why = Das Ergebnis gilt für diesen Wert; ein Fehler des Wertes verfälscht Koordinaten ohne größere Verbesserungen.
    .do = Konvergente und verkantete Aufnahmen ergänzen oder eine Kalibrierung angeben.

held_not_determinable-sigma = Die Standardabweichung dieses Parameters wäre { NUM($sigma, digits: 2) } { $unit }, im Bild { NUM($effect_px, decimals: 0) } px.

held_not_determinable-known_before = { $n } { $n ->
        [one] Kameraparameter ist
       *[other] Kameraparameter sind
     } durch Vorwissen bestimmt, nicht durch die Aufnahmen ({ $cameras } { $cameras ->
        [one] Kamera
       *[other] Kameras
     }).
    .why = Orientierungen und Koordinaten hängen von diesen Annahmen ab.
    .do = Eine Kalibrierung angeben.

held_not_determinable-parameters = Kamera { $camera }: Festgehalten sind { LIST($symbols, most: 10) }.

held_not_determinable-value = Kamera { $camera }, { $symbol }: bekannt { NUM($known_px, decimals: 0) } ± { NUM($known_sigma_px, decimals: 0) } px, gefunden { NUM($found_px, decimals: 0) } ± { NUM($sigma_px, decimals: 0) } px

held_not_determinable-factor = Kamera { $camera }, { $symbol }: bekannt { NUM($known_px, decimals: 0) } px bis auf den Faktor { $factor }, gefunden { NUM($found_px, decimals: 0) } ± { NUM($sigma_px, decimals: 0) } px

held_not_determinable-scale = Kamera { $camera }: { $symbol } festgehalten bei { NUM($value_px, decimals: 0) } px.

held_not_determinable-model = Kamera { $camera }: alle Werte des Modells { $model } festgehalten.
