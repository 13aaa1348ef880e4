rays_diverge = { $n } { $n ->
        [one] Punkt mit divergierenden Strahlen geht
       *[other] Punkte mit divergierenden Strahlen gehen
     } nicht in die Ausgleichung ein: { $ids }.
    .why = Die Zuordnung ist falsch, oder das Objekt ist zu weit entfernt; die übrigen Punkte sind nicht betroffen.
    .do = Diese Punkte in den Aufnahmen prüfen oder von weiter auseinanderliegenden Standpunkten aufnehmen.
