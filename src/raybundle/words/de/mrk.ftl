mrk-empty = Die Datei ist leer.
    .why = Das Fluggerät hat keine Auslösung aufgezeichnet.
    .do = Die Datei erneut vom Fluggerät kopieren.

mrk-not_geographic = Eine MRK-Datei hat geographische Länge und Breite; die Positionen sind in { $crs }.
    .do = Ein anderes Format wählen.

mrk-line = Eine Zeile beginnt mit Nummer, Sekunde und [Woche], nicht mit { $text }.
    .do = Die Zeile korrigieren.

mrk-tag_twice = Die mit { $tag } bezeichnete Zahl kommt zweimal vor.
    .do = Die Zeile korrigieren.

mrk-tag_missing = Die mit { $tag } bezeichnete Zahl fehlt; die Zeile endet mit { $text }.
    .do = Die vollständige Datei beschaffen.

mrk-out_of_range = { $tag } = { $value } liegt außerhalb ± { $limit }.
    .do = Die Zeile korrigieren.

mrk-sigmas_missing = Auf die Höhe müssen drei Standardabweichungen folgen (Nord, Ost, oben).
    .do = Die Zeile vervollständigen.

mrk-sigmas_out_of_range = { $sigmas_m } sind keine Standardabweichungen in Metern (0 bis { $largest_m }).
    .do = Die Zeile korrigieren.

mrk-second_of_week = { NUM($second, digits: 9) } ist keine Wochensekunde.
    .do = Die Zeile korrigieren.
