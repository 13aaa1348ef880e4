scene_joins = Verknüpfungspunkte von Aufnahmen wurden in { $scenes } { $scenes ->
        [one] Szene
       *[other] Szenen
    } gefunden.

scene_joins-scene = { $scene }: { $n } Punkte.
