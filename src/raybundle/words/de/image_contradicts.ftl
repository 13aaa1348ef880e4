image_contradicts = Bild { $image } widerspricht den übrigen: Die Verbesserungen sind { $ratio }-mal so groß (Kamera { $camera }; Grenze { $limit }).
    .why = Das ganze Bild ist betroffen (zufällig mit p { NUM($p, digits: 1) }, Grenze { NUM($limit_p, digits: 1) }): andere Kamera, Fokussierung oder Brennweite, gespiegelt, gedreht, beschnitten oder mit vertauschten Punkten.
    .do = Dem Bild eine eigene Kamera geben, seine Bildpunkte korrigieren oder es weglassen.

image_contradicts-interior = Bild { $image } widerspricht den übrigen: Es hat eine eigene innere Orientierung ({ NUM($rms_px, digits: 2) } px rms).
    .why = Seine Verbesserungen zeigen das { $ratio }-mal so deutlich wie die anderer Bilder der Kamera { $camera } (Grenzen { $limit } und { NUM($limit_px, digits: 2) } px); es kann beschnitten, vergrößert, verzerrt oder gezoomt sein.
    .do = Dem Bild eine eigene Kamera geben oder es weglassen.

image_contradicts-rejected = { $images ->
        [one] In { $images } Bild sind
       *[other] In { $images } Bildern sind
     } mehr als { PERCENT($limit) } % der Bildpunkte verworfen (Median { PERCENT($median) } %): { $ids }.
    .why = Das ganze Bild widerspricht den übrigen: andere Kamera, Fokussierung oder Brennweite, gespiegelt oder beschnitten, oder vertauschte Namen.
    .do = Dem Bild eine eigene Kamera geben, seine Bildpunkte korrigieren oder es weglassen.

image_contradicts-without_it = Bild { $image } widerspricht den anderen: sigma0 ist { $sigma0 } ohne es, { $sigma0_with } mit ihm.
    .why = Es kann von einer anderen Kamera stammen, oder seine Bildpunkte haben falsche Namen.
    .do = Seine Bildpunkte korrigieren, ihm eine eigene Kamera geben oder es weglassen.

image_contradicts-origin = { $n } { $n ->
     [one] Bild hat
     *[other] Bilder haben
    } Bildpunkte links und oberhalb des Formats: { $names }.
    .why = Der Ursprung der Bildpunkte ist wohl die Bildmitte.
    .do = Pixel von der linken oberen Ecke aus angeben, x nach rechts und y nach unten.

image_contradicts-camera_constant = { $images } { $images ->
     [one] Bild hat
     *[other] Bilder haben
    } eine andere Kamerakonstante, { NUM($ratio, digits: 5) }-mal die der anderen: { $names }.
    .why = sigma0 ist { $sigma0 } mit einer Kamerakonstante je Bild, { $sigma0_given } mit einer für alle: andere Kamera, Brennweite oder Fokussierung.
    .do = Diesen Bildern eine eigene Kamera geben.

image_contradicts-matches = { $n } { $n ->
     [one] Aufnahme widerspricht
     *[other] Aufnahmen widersprechen
    } den anderen: wenige Zuordnungen passen zur Orientierung: { LIST($names, most: 5) }.
    .why = Höchstens { PERCENT($share) } % passen (andere { PERCENT($median) } %, Grenze { PERCENT($limit) } %): andere Kamera oder anderer Zoom, gestreckt, beschnitten oder am falschen Ort.
    .do = Weglassen, oder eine eigene Kamera angeben: { OPTION("own_camera", "PATTERN") }.
