measurement-unknown_points = { $name } n'a pas de point { $points }.

measurement-shapes = { $name } : { $n } noms, coordonnées de forme ({ $xyz }), covariance de forme ({ $covariance }).

measurement-point_twice = { $name } contient deux fois le point { $point }.

measurement-points = Mesure : { $points } points sur { $images } photographies de { $of }.

measurement-precision = Écart-type d'une coordonnée : { NUM($rms, digits: 2) } { $free_scale ->
        [yes] millièmes, échelle arbitraire
        *[no] mm
    } (EMQ), maximum { NUM($largest, digits: 2) } (point { $point }).

measurement-fit = Écarts aux valeurs nominales : { NUM($rms_mm, digits: 2) } mm (EMQ), maximum { NUM($largest_mm, digits: 2) } mm ({ $point }) ; { $significant } significatifs sur { $of }.

measurement-tolerances = Tolérances (ISO 14253-1) : { $within } respectées, { $beyond } dépassées{ $beyond ->
        [0] {""}
        *[other] {" "}({ $names })
    }, { $undecided } indécises.

measurement-scale = Échelle de l'ajustement : { NUM($scale, decimals: 7) } ± { NUM($sigma, digits: 1) }.

measurement-lengths = { $n } longueurs connues : erreur { NUM($rms_mm, digits: 2) } mm (EMQ), maximum { NUM($largest_mm, digits: 2) } mm ({ $start } - { $end }).

measurement-length_test = { PERCENT($within) } % des erreurs sont dans deux écarts-types ; test global F = { $F } ({ P($p) }).

measurement-lengths_served = { $independent ->
        [yes] { $n } longueurs ont servi de bases d'échelle.
        *[no] Toutes les longueurs ont servi de bases d'échelle : elles ne sont pas un test.
    }
