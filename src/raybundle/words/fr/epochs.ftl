epochs-datum_points_missing = Des points de référence manquent dans certaines époques : { $names }.

epochs-only_one = Un test de congruence demande au moins deux époques.

epochs-too_few_common = { $epochs } : { $n } points ont des noms communs ; il en faut { $least }.

epochs-no_sigmas = { $first } et { $second } n'ont pas d'écarts-types.

epochs-covariance_singular = La matrice de covariance des époques est singulière au-delà de la référence.

epochs-mirrored = Les points de { $first } et { $second } sont des images miroir.

epochs-scattered = Les points de { $first } et { $second } ne concordent pas : seulement { $agree } sur { $n }.

epochs-other_unit = Les distances dans { $first } valent { NUM($factor, digits: 6) } fois celles de { $second }.

epochs-points_in_line = Les { $n } points communs sont alignés ou confondus dans { $epoch }.

epochs-same_observations = { $first } et { $second } sont la même mesure.

epochs-faulty = { $name } a lui-même { $n } fautes.

epochs-stable_points_differ = Les points stables diffèrent de plus que leurs écarts-types ({ P($p) }).

epochs-free_scale = L'échelle de { $names } n'est pas fixée : une dilatation de tous les points n'est pas détectée ({ $scale_ppm } ppm).

epochs-points_unknown = Aucune mesure ne contient { LIST($points, most: 10) }.
