facade-wall = Wand: { $kind ->
        [vertical] lotrechte
        [horizontal] waagerechte
        *[other] ausgleichende
    } Ebene durch { $n } von { $of } Punkten, Relief von { NUM($back, digits: 2) } bis { NUM($front, digits: 2) } { $unit }.

facade-picture = Echtes Orthofoto: { $width } x { $height } px von { $pixel } { $unit }.

facade-coverage = Pixel: { PERCENT($share) } % auf gemessenen Höhen, { PERCENT($filled) } % ergänzt, { PERCENT($white) } % weiß.

facade-place_sigma = Standardabweichung des Ortes eines Pixels: { NUM($sigma, digits: 2) } { $unit } (Median).

facade-no_scale = Der Maßstab ist nicht bestimmt: Blatt und Zeichnung entfallen.
    .do = orient eine Maßstabsstrecke ({ OPTION("scale_bar", "A", "B", "LENGTH", "SIGMA") }), zwei Passpunkte oder Positionen geben; dann wiederholen.
