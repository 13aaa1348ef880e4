displacement-points = { $moved ->
        [0] Aucun des { $n } points communs déplacé
        *[other] { $moved } des { $n } points communs déplacés : { $names }
    } (taux de fausse alarme { PERCENT($error_rate) } %).

displacement-level_of_detection = Seuil de détection (puissance 80 %) : { NUM($median_mm, digits: 2) } mm (médiane), { NUM($largest_mm, digits: 2) } mm (maximum).

displacement-no_level_of_detection = Certains déplacements ne sont pas détectables : trop peu de points stables.

displacement-tests = Congruence de tous les points F = { $F } ({ P($p) }), des stables F = { $F_stable } ({ P($p_stable) }).

displacement-by_place = { $n } points identifiés par leur position, non par leur nom.

displacement-axes = Axes X, Y, Z : ceux de { $file_name }, ajustés par { $points }.

displacement-unsure = { $n } { $n ->
    [one] région
    *[other] régions
 } sans mouvement certain : moyenne intérieure inférieure à { $limit } écarts-types.
