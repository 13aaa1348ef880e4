given_rejected = { $n } { $n ->
        [one] Bildbeobachtung wurde
       *[other] Bildbeobachtungen wurden
    } in einer früheren Ausgleichung verworfen und { $n ->
        [one] geht
       *[other] gehen
    } nicht in die Ausgleichung ein.
    .do = Die Spalte rejected in observations.csv löschen, um sie neu zu testen.
