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

displacement-one_date = Toutes les photos sont du { $date } : aucun déplacement.

displacement-dates = { LIST($dates, most: 4) } : { $moved ->
        [0] aucun des { $points } points déplacé
        *[other] { $moved } points sur { $points } déplacés : { LIST($names, most: 5) }
    } ; zones déplacées : { $areas } (taux de fausse alarme { PERCENT($error_rate) } %).

displacement-largest = Plus grand déplacement : { $point }, { NUM($length_mm, digits: 3) } mm ± { NUM($sigma_mm, digits: 2) } mm du { $start } au { $end }.

displacement-area = { $name } ({ $n } points) : déplacement moyen { NUM($length_mm, digits: 3) } mm ± { NUM($sigma_mm, digits: 2) } mm jusqu’au { $end }.

displacement-area_uneven = { $name } ({ $n } points) : déplacement inégal, de { NUM($shortest_mm, digits: 2) } mm à { NUM($longest_mm, digits: 3) } mm jusqu’au { $end }.

displacement-changes = { $n } déplacements antérieurs : changés de { NUM($median, digits: 2) } écarts-types (médiane), { NUM($largest, digits: 2) } (maximum, { $point }).

displacement-dates_changed = Dates changées : { LIST($before, most: 5) } sont devenues { LIST($now, most: 5) }.

displacement-not_compared = Aucun des { $n } déplacements antérieurs n'est comparable : dates ou points ont changé.

displacement-untested = { $n } { $n ->
        [one] point déplacé n'est pas contrôlable
        *[other] points déplacés ne sont pas contrôlables
    } : { LIST($names, most: 5) }.
    .why = Un point image faux explique aussi bien le déplacement.
    .do = Prendre plus de photos à chaque date.

displacement-velocity = Le plus rapide : { $name }, { NUM($speed_mm, digits: 3) } mm ± { NUM($sigma_mm, digits: 2) } mm par an ({ $other } mouvements sur { $n } ne sont pas constants).
