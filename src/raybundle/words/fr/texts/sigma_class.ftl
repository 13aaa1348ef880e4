sigma_class-above = au-dessus de { NUM($limit, digits: 2) } { $unit }

sigma_class-all = tous { NUM($sigma, digits: 2) } { $unit }

sigma_class-by_wanted = { $place ->
        [far_below] bien en dessous
        [below] en dessous
        [just_below] juste en dessous
        *[above] au-dessus
    } : jusqu’à { NUM($limit, digits: 2) } { $unit }

sigma_class-far_above = bien au-dessus

sigma_class-head = écart-type d’une coordonnée

sigma_class-head_wanted = écart-type d’une coordonnée ; demandé : { NUM($wanted, digits: 3) } { $unit }

sigma_class-to = jusqu’à { NUM($limit, digits: 2) } { $unit }

sigma_class-worst = le plus grand : { NUM($sigma, digits: 3) } { $unit }
