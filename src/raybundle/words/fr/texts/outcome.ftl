outcome-name = { $name ->
        [accuracy] Exactitude exigée
        [asprs] Classe d'exactitude ASPRS
        [tolerances] Tolérances
        [displacements] Déplacements
        [limit] Limite des déplacements
        *[lengths] Longueurs
    }

outcome-not_kept = Non respecté : { $name ->
        [accuracy] exactitude exigée
        [asprs] classe d'exactitude ASPRS
        [tolerances] tolérances
        [limit] limite des déplacements
        *[lengths] erreurs admissibles des longueurs
    }.

outcome-lengths = { $over ->
        [0] Les { $n } erreurs sont dans les limites.
        *[other] { $over } erreurs sur { $n } dépassent les limites.
    }

outcome-tolerances = { $within } dans la tolérance, { $beyond } hors tolérance, { $undecided } indécis (à deux écarts-types).

outcome-beyond = { $point } : { NUM($deviation_mm, digits: 2) } mm, tolérance { NUM($tolerance_mm, digits: 6) } mm.

outcome-more_beyond = { $n } autres hors tolérance.

outcome-length_errors = { $n } { $n ->
        [one] longueur
        *[other] longueurs
    } { $independent ->
        [yes] { $n ->
            [one] indépendante
            *[other] indépendantes
        }
        *[no] { $n ->
            [one] compensée
            *[other] compensées
        }
    } : erreur maximale { NUM($largest_mm, digits: 2) } mm ({ $start } – { $end }), EMQ { NUM($rms_mm, digits: 2) } mm{ $independent ->
        [yes] .
        *[no] {" "}; barres d'échelle, pas un test.
    }

outcome-length_test = { PERCENT($within) } % dans deux écarts-types ; F { NUM($f) } ({ P($p) }) : { $contradicts ->
        [yes] écarts-types trop petits
        *[no] compatible
    }.

outcome-kept = { $kept ->
        [yes] Respecté.
        *[no] Non respecté.
    }

outcome-no_heights = Altitude : { NUM($wanted, digits: 4) } { $wanted_unit } exigés, non évalué : aucune altitude donnée, altitudes relatives.

outcome-not_precise = { $part ->
        [horizontal] Planimétrie
        *[vertical] Altitude
    } : { NUM($wanted, digits: 4) } { $wanted_unit } exigés, non respecté : écart-type médian { NUM($median) } { $median_unit }.

outcome-only_control = { $part ->
        [horizontal] Planimétrie
        *[vertical] Altitude
    } : { NUM($wanted, digits: 4) } { $wanted_unit } exigés, non évalué : pas de points de contrôle.
    .why = Validation croisée des points d'appui : EMQ { NUM($rms) } { $rms_unit }.

outcome-no_check_points = { $part ->
        [horizontal] Planimétrie
        *[vertical] Altitude
    } : { NUM($wanted, digits: 4) } { $wanted_unit } exigés, non évalué : pas de points de contrôle.

outcome-accuracy = { $part ->
        [horizontal] Planimétrie : RMSE_H
        *[vertical] Altitude : RMSE_V
    } { NUM($found) } { $found_unit } sur { $n } { $n ->
        [one] point
        *[other] points
    } de contrôle, { NUM($wanted, digits: 4) } { $wanted_unit } exigés : { $verdict ->
        [kept] respecté.
        [lost] non respecté.
        [few] non évalué (moins de { $needed } points de contrôle).
        *[other] pas d'énoncé ASPRS testé.
    }
    .why = { $verdict ->
            [unsurveyed] La norme exige les écarts-types des points de contrôle.
            [untested] La norme exige { $needed } points de contrôle.
            *[other] {""}
        }

outcome-see_report = Non respecté, voir le rapport du résultat.
