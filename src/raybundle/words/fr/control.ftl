control-own_measurements = Le fichier a ses propres mesures ; { $measurements } ne peut être ajouté.

control-no_coordinate = Point { $point } : aucune coordonnée.

control-normal = Point { $point } : nX, nY, nZ incomplets ou nuls.

control-none_in_block = Le bloc n'a ni points d'appui ni points de contrôle.
