sigma_class-above = über { NUM($limit, digits: 2) } { $unit }

sigma_class-all = alle { NUM($sigma, digits: 2) } { $unit }

sigma_class-by_wanted = { $place ->
        [far_below] weit darunter
        [below] darunter
        [just_below] knapp darunter
        *[above] darüber
    }: bis { NUM($limit, digits: 2) } { $unit }

sigma_class-far_above = weit darüber

sigma_class-head = Standardabweichung einer Koordinate

sigma_class-head_wanted = Standardabweichung einer Koordinate; gefordert: { NUM($wanted, digits: 3) } { $unit }

sigma_class-to = bis { NUM($limit, digits: 2) } { $unit }

sigma_class-worst = schlechtester Wert: { NUM($sigma, digits: 3) } { $unit }
