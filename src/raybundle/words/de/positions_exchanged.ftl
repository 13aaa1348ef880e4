positions_exchanged = Die Positionen von { $first } und { $second } sind wohl vertauscht; keine von beiden wird verwendet.
    .why = Die beiden Positionen sind { NUM($before_m, digits: 2) } m von dem Ort entfernt, den die Aufnahmen und die anderen Positionen ergeben, vertauscht { NUM($after_m, digits: 2) } m.
    .do = Die Namen in der Positionsdatei oder die Uhr des Empfängers prüfen.
