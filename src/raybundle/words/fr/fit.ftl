fit-unknown_points = Des points choisis pour l'ajustement ne sont pas à la fois mesurés et nominaux : { $names }.

fit-too_few_selected = Seulement { $n } points sont choisis pour l'ajustement ({ $names }).

fit-too_few_common = { $n } des { $nominal } points nominaux sont mesurés sous le même nom ; il en faut { $least }.

fit-points_in_line = Les { $n } points de l'ajustement sont alignés ou confondus.

fit-covariance_singular = La matrice de covariance des points ajustés est singulière.

fit-other_unit = Les points nominaux sont { NUM($ratio, digits: 4) } fois plus éloignés que les points mesurés.
