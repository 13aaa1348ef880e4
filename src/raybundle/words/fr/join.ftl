join-one_block = Il faut au moins deux blocs à joindre.

join-too_few_common = { $name } et { $base } ont { $n } points communs avec coordonnées ; il en faut { $least }.

join-control_contradicts = Point { $point } : les coordonnées données dans { $name } et { $base } diffèrent de { $apart } { $unit } (limite { $limit } { $unit }).

join-vertical_tilted = Le repère de { $base } est incliné de { NUM($tilt_deg, digits: 2) }° par rapport à la verticale de { $name }.

join-cameras_differ = La caméra { $camera } de { $name } n'est pas celle du même nom dans l'autre bloc.
