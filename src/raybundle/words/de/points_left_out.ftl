points_left_out = { $n } { $n ->
        [one] Punkt wurde
       *[other] Punkte wurden
    } ausgeschlossen: Die Strahlen schneiden sich nicht.
    .why = Das Ergebnis hat keine Koordinaten dieser Punkte; die übrigen Punkte sind nicht betroffen.
    .do = Werden diese Punkte gebraucht, sie in Aufnahmen aus anderen Richtungen messen.
