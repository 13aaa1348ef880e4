outside_format = { $n } { $n ->
        [one] Bildpunkt liegt
       *[other] Bildpunkte liegen
     } außerhalb des Formats von { $ids }.
    .why = Am weitesten: Punkt { $point } bei { NUM($x_px, digits: 6) }; { NUM($y_px, digits: 6) } px in { $image } ({ $width_px } × { $height_px } px).
    .do = width_px und height_px der Kamera sowie Einheit und Ursprung der Bildpunkte prüfen (äußere Ecke des ersten Pixels, y nach unten).
