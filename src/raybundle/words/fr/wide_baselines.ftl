wide_baselines = { $joined ->
        [one] 1 photographie est rattachée
        *[other] { $joined } photographies sont rattachées
    } par { $pairs } couples d'autres méthodes : { LIST($methods, most: 3) }.
    .why = Le premier appariement les laissait de côté ou dans une autre partie.
