verdict-points_rms = { $n } { $n ->
        [one] point
        *[other] points
    } objet, écart-type { NUM($sigma, digits: 2) } { $unit } (EMQ d'une coordonnée).

verdict-points_median = { $n } points objet, écart-type d'une coordonnée { NUM($sigma, digits: 2) } { $unit } (médiane ; EMQ { NUM($rms, digits: 2) }).

verdict-few_points = { $n } { $n ->
        [one] point
        *[other] points
    } sur { $of } { $n ->
        [one] fournit
        *[other] fournissent
    } { PERCENT($share) } % de la variance.

verdict-points_plan = { $n } points objet, écart-type { NUM($sigma, digits: 2) } { $unit } (EMQ en X et Y) ; altitudes relatives.

verdict-points_relative = { $n } points objet, précision relative 1 : { $relative } ; pas d'échelle absolue.

verdict-relative = Précision relative 1 : { $relative } (moyenne).

verdict-at_check_points = Points de contrôle : EMQ { NUM($rms, digits: 2) } { $unit }.

verdict-at_lengths = { $n } longueurs indépendantes : EMQ { NUM($rms_mm, digits: 2) } mm.

verdict-no_statistics = Coordonnées sans écarts-types : statistiques désactivées.

verdict-all_held = Tous les points objet et images sont fixes.

verdict-centres = Écart-type (moyenne) : centres de projection { NUM($centre) } { $unit }, angles { NUM($angle_deg) }°.

verdict-no_redundancy = Aucune redondance : le résultat n'est pas contrôlé.

verdict-contradicting = Les observations se contredisent : σ₀ = { NUM($sigma0, digits: 2) } (a priori 1). Chercher d'abord la cause.

verdict-faults = { $n } { $n ->
        [one] défaut
        *[other] défauts
    } à régler avant usage (voir les avertissements).

verdict-systematic = Les résidus ont une part systématique, non comprise dans ces chiffres (voir les avertissements).

verdict-scale_unchecked = Aucune seconde longueur ne confirme l'échelle.

verdict-fits_worse = Les résidus sont { NUM($sigma0, digits: 2) } fois plus grands que prévu a priori ; les écarts-types en tiennent compte.

verdict-fits_better = Les résidus sont plus petits que prévu (σ₀ = { NUM($sigma0, digits: 2) }).

verdict-fits = Les résidus correspondent à la précision a priori.

verdict-each_axis = { $axes ->
        [xyz] { $a } { NUM($x) } ; { $b } { NUM($y) } ; { $c } { NUM($z) }
        [xy] { $a } { NUM($x) } ; { $b } { NUM($y) }
        [z] { $c } { NUM($z) }
        *[other] EMQ { NUM($all) }
    } { $unit }.
