mounting-no_attitudes = Kein Bild hat eine ausgeglichene Orientierung und gemessene Lagewinkel.
    .do = Die Lagewinkel der orientierten Bilder angeben.

mounting-no_positions = Kein Bild hat eine ausgeglichene Orientierung und eine gemessene Position.
    .do = Die Positionen der orientierten Bilder angeben.

mounting-lever_arm = { $n } { $n ->
        [one] Bild hat
       *[other] Bilder haben
     } eine Orientierung und eine Position; ein Exzentrizitätsvektor braucht zwei.
    .do = Mehr Positionen orientierter Bilder angeben.
