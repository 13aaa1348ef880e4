mark_rejected = Die Bildmessung des Punktes { $point } in { $image } liegt { NUM($off_px, decimals: 0) } px neben den anderen, weggelassen.
    .why = Die Grenze ist { NUM($limit_px, digits: 4) } px{ $hint ->
     [same_place] ; Punkt { $other } ist an derselben Stelle gemessen
     [near] ; sie liegt { NUM($other_px, digits: 2) } px von Punkt { $other }
     *[none] { "" }
    }.
    .do = Den Namen prüfen und neu messen.

mark_rejected-test = Die Bildmessung des Punktes { $point } in { $image } widerspricht den anderen und ist weggelassen.
    .why = { $kind ->
     [behind_camera] Der Punkt liegt hinter der Kamera.
     [rays_diverge] Die Strahlen des Punktes laufen auseinander.
     [single_ray] Die anderen Strahlen des Punktes wurden verworfen.
     [given] Die Bildmessung ist in den gegebenen Beobachtungen ausgeschlossen.
     [blunder_not_located] Einer der Strahlen des Punktes ist ein grober Fehler; welcher, ist nicht eindeutig.
     *[other] Die Bildmessung ist ein grober Fehler.
    }{ $tested ->
     [yes] { "" } Testgröße { NUM($tau, decimals: 2) }, Grenze { NUM($limit, decimals: 2) }.
     *[no] { "" }
    }
    .do = Den Punkt neu messen.
