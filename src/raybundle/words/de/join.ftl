join-one_block = Zum Verbinden sind mindestens zwei Blöcke nötig.

join-too_few_common = { $name } und { $base } haben { $n } { $n ->
        [one] gemeinsamen Punkt
       *[other] gemeinsame Punkte
     } mit Koordinaten; nötig sind { $least }.
    .why = Es zählen benannte und codierte Punkte.
    .do = Mehr gemeinsame Punkte in beiden Blöcken messen.

join-control_contradicts = Punkt { $point }: Gegebene Koordinaten in { $name } und { $base } unterscheiden sich um { $apart } { $unit } (Grenze { $limit } { $unit }).
    .why = { $others ->
        [0] Die Grenze folgt aus den Standardabweichungen.
        [one] Die Grenze folgt aus den Standardabweichungen. 1 weiterer Punkt widerspricht ebenfalls.
       *[other] Die Grenze folgt aus den Standardabweichungen. { $others } weitere Punkte widersprechen ebenfalls.
     }
    .do = Die Koordinaten berichtigen oder beide Blöcke in ein Koordinatensystem transformieren.

join-vertical_tilted = Das System von { $base } ist um { NUM($tilt_deg, digits: 2) }° gegen die Lotrichtung von { $name } geneigt.
    .why = { $name } hat Beobachtungen, die sich auf die Lotrichtung beziehen: { $tables }.
    .do = { $name } zuerst angeben oder auch { $base } horizontieren.

join-cameras_differ = Kamera { $camera } von { $name } ist nicht die gleichnamige Kamera des anderen Blocks.
    .why = Sie sind { $model }, { $width_px } x { $height_px } px, und { $other_model }, { $other_width_px } x { $other_height_px } px.
    .do = Sie als verschiedene Kameras behandeln.
