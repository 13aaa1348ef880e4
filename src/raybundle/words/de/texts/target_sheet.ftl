target_sheet-printed = { $n } { $points ->
        [yes] Punkte
        *[no] Marken
    } von { $target } auf { $pages } { $pages ->
        [one] Seite
        *[other] Seiten
    } { $paper }{ $tiles ->
        [0] {""}
        *[other] , gedruckt als { $tiles } Seiten { $tile }
    }.

target_sheet-chosen = Gewählt: { $n } Marken von { $target }.

target_sheet-distinct = Unterscheidbar, wenn { $hidden } benachbarte von { $bits } Sektoren verdeckt sind; kleinster Abstand { $distance } Sektoren.
