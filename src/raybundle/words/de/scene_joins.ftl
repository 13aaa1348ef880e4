scene_joins = Verknüpfungspunkte von Aufnahmen wurden in { $scenes } { $scenes ->
        [one] Szene
       *[other] Szenen
    } gefunden.

scene_joins-scene = Szene { $scene } enthält { $n } { $n ->
        [one] Verknüpfungspunkt
        *[other] Verknüpfungspunkte
    } von Aufnahmen.
