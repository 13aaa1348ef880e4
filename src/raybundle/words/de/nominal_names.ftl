nominal_names = Soll- und Messpunkte passen nicht: Nur { $agree } von { $n } stimmen überein, auf { NUM($rms_mm, digits: 2) } mm (rms).
    .why = Die Namen gehören zu einem anderen Objekt oder sind vertauscht.
    .do = Die Punktnamen beider Dateien prüfen.
