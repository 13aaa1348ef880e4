position-beyond_degrees = { NUM($value, digits: 10) }° liegt außerhalb ± { $limit }°.
    .do = Prüfen, ob Länge und Breite vertauscht sind.
