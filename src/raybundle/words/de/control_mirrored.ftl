control_mirrored = Die Passpunktkoordinaten aus { $name } sind gespiegelt: Gespiegelt passen sie auf { NUM($rms_mm, digits: 2) } mm (rms).
    .why = Kein Passpunkt nimmt teil.
    .do = Die Achsen der Datei berichtigen: Zwei sind vertauscht, oder eine hat das falsche Vorzeichen.
