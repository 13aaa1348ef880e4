zoom-range = { $range_mm } mm, résolution { $resolution_mm } mm : pas une plage de focales.

zoom-coefficient_count = Coefficients : { $n } ; de 1 à { $most } possibles.

zoom-out_of_range = Caméra { $camera } : la focale EXIF { NUM($focal_mm, digits: 4) } mm est hors de la plage étalonnée { NUM($low_mm, digits: 4) } à { NUM($high_mm, digits: 4) } mm.

zoom-too_few_settings = { $n } réglages du zoom sont donnés ; il en faut { $least }.

zoom-setting_given_twice = Deux étalonnages ont la focale EXIF { $focal_mm } mm.

zoom-settings_differ = Les étalonnages à { $first_mm } et { $second_mm } mm diffèrent (format, modèle ou paramètres libres).

zoom-held_values_differ = { LIST($parameters, most: 20) } fixé(s) à des valeurs différentes à { $first_mm } et { $second_mm } mm.

zoom-lenses_differ = Les réglages proviennent de caméras ou d'objectifs différents (EXIF).

zoom-focal_length_unknown = Caméra { $camera } : la focale EXIF est inconnue.
