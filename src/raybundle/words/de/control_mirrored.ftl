control_mirrored = Die Passpunktkoordinaten aus { $name } sind gespiegelt: Gespiegelt passen sie auf { NUM($rms_mm, digits: 2) } mm (rms).
    .why = Kein Passpunkt nimmt teil.
    .do = Die Achsen der Datei berichtigen: Zwei sind vertauscht, oder eine hat das falsche Vorzeichen.

control_mirrored-points = Die Koordinaten von { $n } Pass- und Kontrollpunkten sind gespiegelt; keine nehmen teil: { LIST($ids, most: 8) }.
    .why = Sie passen wie angegeben auf { NUM($rms_m, digits: 2) } m zu den Aufnahmen, gespiegelt auf { NUM($mirrored_m, digits: 2) } m.
    .do = Die Achsen in der Datei berichtigen: Zwei sind vertauscht, oder eine hat das entgegengesetzte Vorzeichen (Tiefen statt Höhen).

control_mirrored-axes = { $geographic ->
     [yes] Breite und Länge
     *[no] Ost- und Nordwert
    } der Passpunkte sind wohl vertauscht; kein Passpunkt nimmt teil.
    .why = Die { $n } Punkte passen wie angegeben auf { NUM($before_m, digits: 2) } m zu den Aufnahmen, vertauscht auf { NUM($after_m, digits: 2) } m.
    .do = Die beiden Spalten in der Passpunktdatei vertauschen.
