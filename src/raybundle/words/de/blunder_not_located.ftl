blunder_not_located = { $n } { $n ->
        [one] Punkt nimmt
       *[other] Punkte nehmen
     } nicht teil: zu wenige Strahlen, um den falschen zu bestimmen.
    .why = Weniger als drei Strahlen blieben übrig, oder zwei Strahlen erklären den Fehler gleich gut: { $ids }.
    .do = Diese Punkte in mehr Aufnahmen messen.
