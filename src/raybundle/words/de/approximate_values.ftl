approximate_values-images = { $n } { $n ->
        [one] Bild hat
       *[other] Bilder haben
     } keine äußere Orientierung: { LIST($images, most: 10) }.
    .do = Näherungswerte angeben.

approximate_values-points = { $n } { $n ->
        [one] Punkt hat
       *[other] Punkte haben
     } keine Koordinaten: { LIST($points, most: 10) }.
    .do = Näherungswerte angeben.

approximate_values-images_beside_scenes = { $n } { $n ->
        [one] Bild hat
       *[other] Bilder haben
     } neben Satellitenszenen keine äußere Orientierung: { $images }.
    .do = Die Aufnahmen für sich ausgleichen und ihr Ergebnis im System des Blocks als Näherungswerte angeben.

approximate_values-points_beside_scenes = { $n } { $n ->
        [one] Punkt hat
       *[other] Punkte haben
     } weder Koordinaten noch Strahlen zweier Szenen: { $points }.
    .do = Die Aufnahmen für sich ausgleichen und ihr Ergebnis im System des Blocks als Näherungswerte angeben.
