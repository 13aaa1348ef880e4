position-beyond_degrees = { NUM($value, digits: 10) }° liegt außerhalb ± { $limit }°.
    .do = Prüfen, ob geographische Länge und Breite vertauscht sind.
