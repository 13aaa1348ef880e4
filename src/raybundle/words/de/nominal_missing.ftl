nominal_missing = { $n } { $n ->
        [one] Sollpunkt wurde
       *[other] Sollpunkte wurden
     } nicht gemessen: { LIST($ids, most: 10) }.
