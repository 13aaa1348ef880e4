rtklib-datum = Die Positionen beziehen sich auf das Datum { $datum }.
    .do = Die Lösung in WGS84 schreiben.

rtklib-heights = Die Höhen sind { $heights }; sie beziehen sich auf ein Geoid, das die Datei nicht nennt.
    .do = Ellipsoidische Höhen schreiben (RTKLIB: out-height =ellipsoidal).

rtklib-columns = Die Spalten sind { $names }.
    .do = Die Lösung als { $needed } schreiben.

rtklib-line = Eine Zeile beginnt mit Datum und Zeit oder Woche und Sekunde, nicht mit { $text }.
    .do = Die Zeile korrigieren.

rtklib-date = { $text } ist kein gültiges Datum mit Zeit.
    .do = Die Zeile korrigieren.

rtklib-baselines = Die Datei hat Basislinien von einer Basisstation.
    .do = Die Lösung als geographische Breite, Länge und Höhe schreiben.

rtklib-not_decimal_degrees = { $value }: Die Winkel sind nicht in Dezimalgrad.
    .do = Dezimalgrad schreiben.

rtklib-beyond_degrees = Eine geographische Breite oder Länge liegt außerhalb ± 90° oder ± 180°.
    .do = Prüfen, ob es die richtige Datei ist.

rtklib-track = Die Datei ist eine Trajektorie von { $n } Epochen ohne Bezug zu Aufnahmen.
    .do = Die Lösung der Auslösezeiten angeben (NAME_events.pos).
