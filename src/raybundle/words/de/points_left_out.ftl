points_left_out = { $n } { $n ->
        [one] Punkt wurde
       *[other] Punkte wurden
    } ausgeschlossen: Die Strahlen schneiden sich nicht.
