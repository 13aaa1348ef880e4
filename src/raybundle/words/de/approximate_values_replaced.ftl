approximate_values_replaced-points = { $n } { $n ->
        [one] Verknüpfungspunkt lag weit neben den Strahlen und wurde
       *[other] Verknüpfungspunkte lagen weit neben den Strahlen und wurden
    } durch Vorwärtsschnitt neu bestimmt: { $ids }.
    .do = points.csv prüfen.

approximate_values_replaced-unsolvable = Die Näherungswerte des Blocks führen zu keiner Lösung und wurden ersetzt (sigma0 jetzt { $sigma0 }).
    .do = images.csv und points.csv prüfen.

approximate_values_replaced-poor = Die Näherungswerte des Blocks führen zu sigma0 { $given_sigma0 } und wurden ersetzt (sigma0 jetzt { $sigma0 }).
    .do = images.csv und points.csv prüfen.

approximate_values_replaced-behind = Die Näherungswerte führen zu { $n } Bildpunkten hinter Kameras und wurden ersetzt (sigma0 jetzt { $sigma0 }).
    .do = images.csv und points.csv prüfen.
