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
