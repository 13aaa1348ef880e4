line_scene-table_order = { $table ->
        [line_times] Zeilenzeiten
       *[viewing_directions] Blickrichtungen
     } ({ $n } Einträge) sind zu wenige oder nicht aufsteigend.
    .do = Mindestens zwei Einträge in aufsteigender Folge angeben.

line_scene-times_not_monotonic = Die Zeilenzeiten nehmen entlang des Bildes weder durchweg zu noch durchweg ab.
    .do = Die Tabelle der Zeilenzeiten korrigieren.

line_scene-ray_misses_body = Der Strahl des Bildpunkts { NUM($x_px, decimals: 2) }, { NUM($y_px, decimals: 2) } px verfehlt den Körper um { NUM($miss_m, decimals: 1) } m.
    .why = Geschnitten wird in der Höhe { $height_m } m; das Bild zeigt den Raum jenseits des Rands, oder die Lagewinkel sind falsch.
    .do = Die Lagewinkel der Szene prüfen.

line_scene-point_not_seen = Punkt { $point } liegt nicht in dieser Szene.
    .why = Er hat die geographische Länge { NUM($longitude_deg, decimals: 6) }°, Breite { NUM($latitude_deg, decimals: 6) }°, Höhe { NUM($height_m, decimals: 1) } m; letzte versuchte Zeile { NUM($last_line, decimals: 1) } von { $lines }.
    .do = Prüfen, ob Punkt und Szene zusammengehören.

line_scene-smooth_unknown = smooth: { $name } ist keine Achse einer Kurve.
    .do = { $n ->
        [0] smooth weglassen; diese Szene hat keine Kurve
       *[other] Eine von { LIST($known, most: 9) } verwenden
     }.

line_scene-below_ground = Die Geländehöhe { $height_m } m liegt { NUM($above_m, decimals: 1) } m über dem Sensor.
    .do = Die mittlere Geländehöhe als height_m angeben.
