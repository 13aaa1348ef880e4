mask_refused = Die { $n ->
        [one] Maske
       *[other] Masken
    } von { LIST($ids, most: 3) } { $n ->
        [one] ist
       *[other] sind
    } nicht verwendbar; { $n ->
        [one] die Aufnahme wird
       *[other] die Aufnahmen werden
    } ganz verwendet.
    .why = Merkmale im Hintergrund können in diesen Aufnahmen falsche Punkte ergeben.
    .do = Die Masken wie unten beschrieben korrigieren, dann den Befehl erneut ausführen.
