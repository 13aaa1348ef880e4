positions_axes-list = { $geographic ->
     [yes] Geographische Länge und Breite
     *[no] Ost- und Nordwert
    } in { $table } sind wohl vertauscht.
    .why = Diese Positionen sind { $distance_km } km von den Positionen in den Aufnahmen entfernt, vertauscht { $exchanged_km } km; die Positionen in den Aufnahmen werden verwendet.
    .do = Die beiden Spalten in { $table } vertauschen.

positions_axes = Geographische Breite und Länge der Positionen sind wohl vertauscht; keine Position wird verwendet.
    .why = Die { $n } Positionen passen wie angegeben auf { NUM($before_m, digits: 2) } m zu den Aufnahmen, vertauscht auf { NUM($after_m, digits: 2) } m.
    .do = Die beiden Spalten oder ihre Namen in der Positionsdatei vertauschen.
