blunder_not_located = { $n } { $n ->
        [one] Punkt geht
       *[other] Punkte gehen
     } nicht in die Ausgleichung ein: zu wenige Strahlen, um den falschen zu bestimmen.
    .why = Weniger als drei Strahlen blieben übrig, oder zwei Strahlen erklären den Fehler gleich gut: { $ids }.
    .do = Diese Punkte in mehr Aufnahmen messen.
