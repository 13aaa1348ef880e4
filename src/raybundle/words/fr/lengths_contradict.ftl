lengths_contradict = Les erreurs de { $n } longueurs de contrôle valent { NUM($factor, digits: 2) } fois l'écart-type annoncé.

lengths_contradict-scale = Les erreurs de { $n } longueurs de contrôle valent { NUM($factor, digits: 2) } fois l'écart-type annoncé.

lengths_contradict-one = Les erreurs de { $n } longueurs de contrôle valent { NUM($factor, digits: 2) } fois l'écart-type annoncé.

lengths_contradict-single = Les erreurs de { $n } longueurs de contrôle valent { NUM($factor, digits: 2) } fois l'écart-type annoncé.

lengths_contradict-length = { $start } - { $end } : erreur { $error_mm } mm, écart-type { NUM($sigma_mm, digits: 2) } mm.
