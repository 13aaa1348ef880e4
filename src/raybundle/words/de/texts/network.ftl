network-stations = { $n } { $n ->
        [one] Aufnahme
        *[other] Aufnahmen
    } von { $object }: { $aim ->
        [calibration] Unsicherheit der Abbildung
        [reliability] kleinster Redundanzanteil
        [mean] mittleres Sigma
        *[worst] schlechtestes Sigma
    } { $reached }{ $target ->
        [none] {""}
        [met] {" "}(gefordert { $wanted })
        *[missed] {" "}(gefordert { $wanted }, nicht erreicht)
    }.

network-precision = Vorhergesagtes Sigma: im Mittel { $mean }, schlechtestes { $worst }, größtes einer Koordinate { $coordinate }.

network-object = Mindestens zweimal gesehen: { PERCENT($share) } % des Objekts, Sigma im Median { $median }, größtes { $largest }{ $known ->
        [yes] {" "}(mit allem Bekannten)
        *[no] {""}
    }.

network-geometry = B/D { NUM($base_to_depth, decimals: 2) }, Strahlen { NUM($rays, decimals: 1) }, Bildmaßstab 1 : { NUM($scale, decimals: 0) }, q { NUM($q, decimals: 2) }, Bild-Sigma { $sigma_px } px.

network-effort = Vor Ort: { NUM($minutes, decimals: 0) } min, { NUM($path_m, decimals: 0) } m Weg.

network-sharp = Scharf von { $near_m } m bis { $far_m ->
        [0] unendlich
        *[other] { $far_m } m
    }.

network-added = Dazu { $n } { $n ->
        [one] Aufnahme
        *[other] Aufnahmen
    } { $again ->
        [yes] von vorhandenen Standpunkten
        *[no] für die ganze sichtbare Oberfläche
    }{ $known ->
        [yes] : { $before } auf { $after }
        *[no] {""}
    }; { PERCENT($share) } % bleiben über dem geforderten Sigma.

network-known = Mit { $control } Passpunkten und { $bars } Maßstabsstrecken{ $bars ->
        [0] {""}
        *[other] {" "}({ $lengths_m } m)
    }: schlechtestes { $worst }, im Mittel { $mean }.

network-calibrated = Damit kalibriert: { $parameters }{ $known ->
        [yes] ; Bildpunkte auf { NUM($worst_px, digits: 2) } px im schlechtesten Fall
        *[no] {""}
    }.

network-next = { $folder }/network.html öffnen; stations.csv nennt die Standpunkte.

network-listed = Aufgelistet: { $n } { $n ->
        [one] Aufnahme
        *[other] Aufnahmen
    }.

network-next_list = { $folder }/list.pdf drucken.

network-judged = { $judged } von { $reached } erreichbaren Kandidaten zeigen genug.

network-lowered = { $goal }: jetzt { $before }, mit { $n } { $n ->
        [one] Aufnahme
        *[other] Aufnahmen
    } { $after }.

network-freed = Damit bestimmt der Block { $parameters }.

network-more_proposals = { $n } weitere { $n ->
        [one] Vorschlag
        *[other] Vorschläge
    }: { $file_name }.

network-proposal = { $name }: { $text }
