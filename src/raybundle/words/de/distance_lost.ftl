distance_lost = { $n } { $n ->
        [one] Strecke nimmt
       *[other] Strecken nehmen
     } nicht teil: Bildpunkte der Enden wurden verworfen ({ $ids }).
    .do = Die Marken dieser Punkte prüfen.
