control_contradicts-scattered = Die Passpunkte aus { $name } passen nicht: Nur { $agree } von { $n } stimmen überein, auf { NUM($rms_mm, digits: 2) } mm (rms).
    .why = Kein Passpunkt nimmt teil; die Achsen sind nicht die der Passpunkte.
    .do = Namen und Koordinaten der Datei prüfen.

control_contradicts-scale = Die Passpunkte aus { $name } und die Maßstabsstrecken unterscheiden sich im Maßstab um { $near_1 ->
        [yes] { NUM($scale_ppm, digits: 4) } ppm
       *[no] einen Faktor von { NUM($factor, digits: 6) }
     }.
    .why = Kein Passpunkt nimmt teil; der Maßstab ist der der Maßstabsstrecken ({ NUM($rms_same_scale_mm, digits: 2) } mm rms ohne den Faktor).
    .do = Die Einheit der Datei und die Längen der Maßstabsstrecken prüfen.

control_contradicts-ambiguous = { $n } Passpunkte aus { $name } widersprechen den übrigen; welche falsch sind, ist nicht eindeutig.
    .why = Alle Passpunkte nehmen teil; eine falsche Koordinate verformt das Ergebnis.
    .do = Koordinaten und Namen von { $ids } prüfen oder Passpunkte ergänzen.

control_contradicts-rejected = { $points } von { $control } Passpunkten: mehr als { PERCENT($limit) } % ihrer Bildpunkte sind verworfen: { $ids }.
    .why = Die Passpunkte widersprechen den Aufnahmen, oder ihre Namen sind vertauscht.
    .do = Koordinaten, Koordinatensystem, Reihenfolge und Vorzeichen der Achsen, Einheit und Namen prüfen.
