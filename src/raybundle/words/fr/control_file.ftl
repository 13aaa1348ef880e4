control_file-no_sigma = { $name } ne contient pas d'écarts-types ; { NUM($off_mm, digits: 2) } mm est supposé.

control_file-not_measured = { $n } point(s) d'appui n'ont pas été mesurés : { LIST($ids, most: 10) }.

control_file-tolerance = La colonne tolerance de { $name } n'est pas utilisée : elle concerne les coordonnées nominales.
