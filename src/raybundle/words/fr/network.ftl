network-covariance_not_positive = Réseau { $network } de coordinates.csv : la matrice de covariance des { $n } points n'est pas définie positive.

network-point_given_twice = Le point { $point } figure dans coordinates.csv (réseau { $network }) et comme appui avec écarts-types dans points.csv.

network-pair_twice = Ces deux points du réseau { $network } figurent dans une ligne précédente.

network-coordinates_missing = Les coordonnées du point manquent (point et other sont identiques).

network-coordinates_of_pair = Une ligne de deux points différents a des coordonnées.

network-point_without_coordinates = Le réseau { $network } n'a pas de ligne avec les coordonnées de l'un des deux points.

network-variance_not_positive = Une variance vaut { $variance } ; elle doit être positive.

network-covariance_not_symmetric = La matrice de covariance du point n'est pas symétrique.

network-no_depth = Les rayons vers chaque point objet sont parallèles : le réseau n'a pas de base.
