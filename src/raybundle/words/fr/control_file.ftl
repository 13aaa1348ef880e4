control_file-no_sigma = { $name } ne contient pas d'écarts-types ; { NUM($off_mm, digits: 2) } mm est supposé.

control_file-not_measured = { $n } point(s) d'appui n'ont pas été mesurés : { LIST($ids, most: 10) }.

control_file-tolerance = La colonne tolerance de { $name } n'est pas utilisée : elle concerne les coordonnées nominales.

control_file-tolerance_unused = La colonne tolerance des points d'appui n'est pas utilisée : elle concerne les coordonnées nominales.

control_file-words_behind_names = { $name } : des mots après le nom du point ne sont pas lus dans { $n } ligne(s).

control_file-no_names = Le fichier n'a pas de noms de points ; les lignes de mêmes X Y Z sont un point : { LIST($names, most: 2) } ...

control_file-sigma_assumed = Coordonnées sans écart-type : { $plan }{ $unit ->
     [none] { "" }
     *[other] { "" } { $unit }
    } en plan et { $height }{ $unit ->
     [none] { "" }
     *[other] { "" } { $unit }
    } en altitude supposés.

control_file-heights_unknown = { $name } : les { $n } altitudes valent toutes { NUM($height, digits: 10) } et sont tenues pour inconnues.

control_file-system_of_others = Système de coordonnées de { $name } : non défini ; { $system } supposé, comme dans { $others }.

control_file-cartesian_assumed = Système de coordonnées de { $name } : non défini ; coordonnées cartésiennes en mètres supposées.

control_file-system_given = Système de coordonnées de { $name } : non défini dans le fichier ; { $system } selon { OPTION("crs") }.

control_file-degrees = Des coordonnées comme { NUM($x, digits: 8) }, { NUM($y, digits: 8) } semblent être longitude et latitude.
