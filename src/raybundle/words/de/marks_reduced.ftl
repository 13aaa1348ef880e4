marks_reduced = Die { $marks } Messungen aus { $table } stammen aus Kopien von { NUM($side_px, digits: 5) } px{ $exact ->
     [yes] { "" }
     *[no] { "" } (± { NUM($sigma_px, digits: 2) } px)
    }, nicht { NUM($full_px, digits: 5) } px.
    .why = Wie angegeben weichen sie um { NUM($before_px, decimals: 0) } px ab, mit dem angebrachten Faktor { NUM($factor, digits: 4) } um { NUM($after_px, digits: 2) } px (Median).
    .do = In den Aufnahmen in voller Größe messen.
