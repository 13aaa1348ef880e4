photographs-found = { $n } { $n ->
        [one] Aufnahme
        *[other] Aufnahmen
    }, { $cameras } { $cameras ->
        [one] Kamera
        *[other] Kameras
    }.

photographs-camera = Kamera { $camera }: { $name }, { $n } { $n ->
        [one] Aufnahme
        *[other] Aufnahmen
    } mit { $width_px } x { $height_px } px.
    .why = c = { NUM($c_px, decimals: 1) } ± { NUM($sigma_px, decimals: 1) } px = { NUM($c_mm, digits: 4) } mm ({ $source }).

photographs-more = und { $n } weitere: { OPTION("json", "True") }.

photographs-small = { $name } hat { $width_px } x { $height_px } px, weniger als { $least_px } auf einer Seite.
    .why = Darin lässt sich kaum etwas messen.
    .do = Prüfen, ob es eine Vorschau des Fotos ist.
