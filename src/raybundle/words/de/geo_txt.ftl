geo_txt-empty = Die Datei ist leer.
    .do = In die erste Zeile das Koordinatensystem schreiben, dann eine Zeile je Aufnahme.

geo_txt-name_is_number = { $value } ist eine Zahl; die erste Spalte ist der Name einer Aufnahme.
    .do = Zeilen schreiben wie { $example }.
