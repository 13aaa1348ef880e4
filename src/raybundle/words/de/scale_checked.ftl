scale_checked = Der Maßstab von { $bars } { $bars ->
        [one] Maßstabsstrecke
       *[other] Maßstabsstrecken
     } ({ $ids }) ist durch { $n } { $n ->
        [one] Prüflänge
       *[other] Prüflängen
     } bestätigt.
    .why = Gemessene Längen weichen um { NUM($scale_ppm, digits: 2) } ± { NUM($sigma_ppm, digits: 2) } ppm ab.
