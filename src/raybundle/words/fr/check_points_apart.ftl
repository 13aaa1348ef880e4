check_points_apart = { $n } point(s) de contrôle s'écartent plus que ne le permettent les écarts-types (en { $axes }).

check_points_apart-axis = { $axis } : écarts de { NUM($factor, digits: 2) } fois leurs écarts-types (limite { NUM($limit, digits: 2) })

check_points_apart-point = { $point } : { NUM($factor, digits: 2) } écarts-types en { $axis } (limite { NUM($limit, digits: 2) })

check_points_apart-no_single_point = Aucun point isolé ne se distingue.
