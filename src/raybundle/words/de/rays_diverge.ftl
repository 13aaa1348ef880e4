rays_diverge = { $n } { $n ->
        [one] Punkt mit divergierenden Strahlen nimmt
       *[other] Punkte mit divergierenden Strahlen nehmen
     } nicht teil: { $ids }.
    .why = Die Zuordnung ist falsch, oder das Objekt ist für diese Standpunkte zu weit entfernt.
