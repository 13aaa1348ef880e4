nominal_mirrored = Die Sollkoordinaten sind gespiegelt: Gespiegelt passen sie auf { NUM($rms_mm, digits: 2) } mm (rms).
    .why = Zwei Achsen sind vertauscht, oder eine hat das falsche Vorzeichen.
    .do = Die Achsen in der Datei der Sollkoordinaten korrigieren.
