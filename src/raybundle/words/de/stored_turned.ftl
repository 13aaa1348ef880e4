stored_turned = { $n } { $n ->
        [one] Bilddatei ist
       *[other] Bilddateien sind
     } um { $turned_deg }° gedreht gespeichert: { $ids }.
    .why = Bildpunkte des Ergebnisses gelten in den Pixeln der Kamera { $camera }, nicht in denen der Datei.
    .do = Bildpunkte in der Datei messen und nicht aus observations.csv übernehmen.

stored_turned-size = { $n } { $n ->
        [one] Bilddatei hat
       *[other] Bilddateien haben
     } eine andere Größe ({ $width_px } × { $height_px } px) als die Kamera { $camera }: { $ids }.
    .why = Bildpunkte des Ergebnisses gelten in den Pixeln der Kamera, nicht in denen der Datei.
    .do = Bildpunkte in der Datei messen und nicht aus observations.csv übernehmen.
