facade-wall = Mur : plan { $kind ->
        [vertical] vertical
        [horizontal] horizontal
        *[other] ajusté
    } par { $n } points sur { $of }, relief de { NUM($back, digits: 2) } à { NUM($front, digits: 2) } { $unit }.

facade-picture = Orthophoto vraie : { $width } x { $height } px de { $pixel } { $unit }.

facade-coverage = Pixels : { PERCENT($share) } % sur des hauteurs mesurées, { PERCENT($filled) } % complétés, { PERCENT($white) } % blancs.

facade-place_sigma = Écart-type de la position d'un pixel : { NUM($sigma, digits: 2) } { $unit } (médiane).

facade-no_scale = L'échelle n'est pas déterminée : ni planche ni dessin ne sont écrits.
    .do = Donner à orient une base de longueur connue ({ OPTION("scale_bar", "A", "B", "LENGTH", "SIGMA") }), deux points d'appui ou des positions, puis répéter.
