control-own_measurements = Le fichier a ses propres mesures ; { $measurements } ne peut être ajouté.

control-no_coordinate = Point { $point } : aucune coordonnée.

control-normal = Point { $point } : nX, nY, nZ incomplets ou nuls.

control-none_in_block = Le bloc n'a ni points d'appui ni points de contrôle.

control-one_place = Les { $n } points d'appui ont les mêmes coordonnées ({ LIST($coordinates, most: 3) }) : { $names }.

control-several_systems = Les points d'appui sont dans des systèmes de coordonnées différents : { $systems }.

control-too_few_measured = Points d'appui avec deux rayons ou plus : { $n } ; il en faut au moins { $least }.

control-point_twice = Le point { $point } est aussi dans { $table }.

control-other_photographs = Aucune des photographies mesurées dans le fichier n'est présente.

control-points_in_line = Les { $n } points d'appui mesurés sont alignés ou confondus : { LIST($points, most: 5) }.

control-other_unit = Les barres d'échelle rendent le réseau { NUM($ratio, digits: 4) } fois plus grand que les appuis.

control-none_in_photograph = Aucun point avec X et Y n'est mesuré dans { $photograph }.

control-too_few_for_datum = { $n } points sur { $total } sont des points d'appui mesurés avec X, Y et Z ; il en faut trois.
