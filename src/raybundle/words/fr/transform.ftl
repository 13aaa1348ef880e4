transform-wrong_shape = Tableau { $name } d'une transformation : forme ({ $shape }), ou valeurs non finies.

transform-observed_unknown = observed = { $value } est inconnu.

transform-scale_not_positive = Le facteur d'échelle de la transformation est { $scale }.

transform-translation_not_finite = La translation de la transformation est { $translation }.

transform-scene = La scène satellite { $scene } ne peut pas être transformée.

transform-geodetic_frame = Le repère objet a un lieu fixe sur la Terre et ne peut pas être transformé.

transform-rotation_not_orthogonal = La rotation de la transformation n'est pas orthogonale : R R' diffère de 1 de { NUM($off, digits: 2) }.

transform-rotation_mirrored = La rotation de la transformation est une réflexion.

transform-sigmas_correlated = { $name } ne peut pas être transformé : les écarts-types de { $parameters } seraient corrélés.

transform-partly_free = { $name } ne peut pas être tourné : parmi { $parameters }, certains sont fixes, d'autres libres.

transform-calibration_incomplete = { $name } ne peut pas être tourné : son étalonnage n'a pas de valeur de { $parameter }.

transform-row_not_possible = { $row } ne peut pas être transformé :

transform-not_given = Une coordonnée manque que la rotation combine avec les coordonnées données.

transform-would_correlate = Ses coordonnées seraient corrélées, ce que des écarts-types seuls n'indiquent pas.

transform-coefficients = Ses coefficients de corrélation ne sont pas ceux de grandeurs observées.

transform-not_observed = { $kind ->
        [coordinate] Une coordonnée
        *[angle] Un angle
    } manque que la rotation combine avec les valeurs observées.

transform-too_correlated = Corrélation trop étroite : plus petite valeur propre { NUM($eigenvalue, digits: 2) } (limite { $limit }).

transform-phi_near_right_angle = phi serait proche d'un angle droit.

transform-vertical_turned = La ligne se rapporte à la verticale, tournée de { $angle_deg }°.

transform-heights_tilted = Les hauteurs d'instrument et de cible suivent la verticale, qui est inclinée.
