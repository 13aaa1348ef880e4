rays_diverge = { $n } { $n ->
        [one] Punkt mit divergierenden Strahlen nimmt
       *[other] Punkte mit divergierenden Strahlen nehmen
     } nicht teil: { $ids }.
    .why = Die Zuordnung ist falsch, oder das Objekt ist zu weit entfernt; die übrigen Punkte sind nicht betroffen.
    .do = Diese Punkte in den Aufnahmen prüfen oder von weiter auseinanderliegenden Standpunkten aufnehmen.
