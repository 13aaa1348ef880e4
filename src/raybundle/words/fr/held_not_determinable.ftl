held_not_determinable-cameras = Les points ne déterminent pas l'orientation interne de { $ids } ; ses valeurs approchées sont fixées.

held_not_determinable = Caméra { $camera } : { $symbol } n'est pas déterminable et est fixé à sa valeur connue { NUM($at, digits: 4) } { $unit }.

held_not_determinable-sigma = L'écart-type de ce paramètre serait { NUM($sigma, digits: 2) } { $unit }, { NUM($effect_px, decimals: 0) } px dans l'image.

held_not_determinable-known_before = { $n } paramètre(s) de caméra tenu(s) par des connaissances a priori, pas par les photos.

held_not_determinable-parameters = Caméra { $camera } : les paramètres tenus sont { LIST($symbols, most: 10) }.

held_not_determinable-value = Caméra { $camera }, { $symbol } : connu { NUM($known_px, decimals: 0) } ± { NUM($known_sigma_px, decimals: 0) } px, trouvé { NUM($found_px, decimals: 0) } ± { NUM($sigma_px, decimals: 0) } px

held_not_determinable-factor = Caméra { $camera }, { $symbol } : connu { NUM($known_px, decimals: 0) } px à un facteur { $factor } près, trouvé { NUM($found_px, decimals: 0) } ± { NUM($sigma_px, decimals: 0) } px

held_not_determinable-scale = Caméra { $camera } : { $symbol } tenu à { NUM($value_px, decimals: 0) } px.

held_not_determinable-model = Caméra { $camera } : toutes les valeurs du modèle { $model } sont tenues.
