mrk-empty = Le fichier est vide.

mrk-not_geographic = Un fichier MRK est en longitude et latitude ; les positions sont en { $crs }.

mrk-line = Une ligne commence par numéro, seconde et [semaine], non par { $text }.

mrk-tag_twice = Le nombre marqué { $tag } figure deux fois.

mrk-tag_missing = Le nombre marqué { $tag } manque ; la ligne finit par { $text }.

mrk-out_of_range = { $tag } = { $value } est hors de ± { $limit }.

mrk-sigmas_missing = Trois écarts-types (nord, est, haut) doivent suivre la hauteur.

mrk-sigmas_out_of_range = { $sigmas_m } ne sont pas des écarts-types en mètres (0 à { $largest_m }).

mrk-second_of_week = { NUM($second, digits: 9) } n'est pas une seconde de semaine.
