marks_reduced = Die { $marks } Messungen aus { $table } stammen aus Kopien von { NUM($side_px, digits: 5) } px, nicht { NUM($full_px, digits: 5) } px{ $exact ->
     [yes] { "" }
     *[no] { "" } (± { NUM($sigma_px, digits: 2) } px)
    }.
    .why = Wie angegeben liegen sie { NUM($before_px, decimals: 0) } px auseinander, mal { NUM($factor, digits: 4) } { NUM($after_px, digits: 2) } px; dieser Faktor ist angebracht, auch an ihren Standardabweichungen.
    .do = In den Aufnahmen in voller Größe messen.
