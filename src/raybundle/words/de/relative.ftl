relative-too_few_points = { $n } gemeinsame Punkte sind gegeben; eine relative Orientierung braucht sechs.
    .do = Mehr gemeinsame Punkte messen.

relative-no_solution = Keine relative Orientierung passt zu sechs von { $n } Punkten auf { $limit_px } px.
    .do = Prüfen, ob gleiche Namen in beiden Bildern gleiche Punkte sind.

relative-parallel_rays = Die Strahlen gemeinsamer Punkte sind auf { NUM($angle_deg, decimals: 3) }° parallel.
    .why = Die Bilder haben fast keine Basis, oder alle Punkte sind weit entfernt.
    .do = Bilder von verschiedenen Standpunkten verwenden.
