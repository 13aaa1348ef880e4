control_mirrored = Die Passpunktkoordinaten aus { $name } sind gespiegelt: Gespiegelt passen sie auf { NUM($rms_mm, digits: 2) } mm (rms).
    .why = Kein Passpunkt geht in die Ausgleichung ein.
    .do = Die Achsen der Datei korrigieren: Zwei sind vertauscht, oder eine hat das falsche Vorzeichen.

control_mirrored-points = Die Koordinaten von { $n } Pass- und Kontrollpunkten sind gespiegelt; keiner geht in die Ausgleichung ein: { LIST($ids, most: 8) }.
    .why = Die Punkte passen wie angegeben auf { NUM($rms_m, digits: 2) } m zu den Aufnahmen, gespiegelt auf { NUM($mirrored_m, digits: 2) } m.
    .do = Die Achsen in der Datei korrigieren: Zwei sind vertauscht, oder eine hat das entgegengesetzte Vorzeichen (Tiefen statt Höhen).

control_mirrored-axes = { $geographic ->
     [yes] Geographische Breite und Länge
     *[no] Ost- und Nordwert
    } der Passpunkte sind wohl vertauscht; kein Passpunkt geht in die Ausgleichung ein.
    .why = Die { $n } Punkte passen wie angegeben auf { NUM($before_m, digits: 2) } m zu den Aufnahmen, vertauscht auf { NUM($after_m, digits: 2) } m.
    .do = Die beiden Spalten in der Passpunktdatei vertauschen.
