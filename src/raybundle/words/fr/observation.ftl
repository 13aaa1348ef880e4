observation-covariance = La covariance { $sxy_px2 } px² est hors de ± { $limit_px2 } px², le produit sx · sy.

observation-sigma_out_of_range = Des écarts-types de { $sx_px } et { $sy_px } px ne sont pas plausibles.

observation-correlation_range = { $correlation } n'est pas un coefficient de corrélation : il doit être compris entre -1 et 1.

observation-correlation_without_sigma = Une corrélation de { $correlation } concerne une valeur non observée.

observation-correlations_not_possible = Les corrélations { $correlations } sont impossibles ensemble (plus petite valeur propre { NUM($eigenvalue, digits: 2) }, limite { $limit }).

observation-image_twice = Cette image a déjà une ligne.

observation-no_sigma = Aucun angle de cette ligne n'a d'écart-type.

observation-value_without_sigma = Une valeur sans écart-type, ou un écart-type sans valeur.

observation-no_value = La ligne n'a pas de valeur observée.

observation-row_refused = Cette ligne n'est pas utilisable : { $detail }.

observation-same_point = Les deux points de cette ligne sont le même.

observation-set_station = La série { $set } a une autre station dans une ligne précédente.

observation-zenith_angle = { NUM($angle_deg, digits: 6) }° n'est pas un angle zénithal (0° à 180°, 0 à 200 gon).

observation-parameter_twice = { $parameter } de cette image a déjà une ligne.
