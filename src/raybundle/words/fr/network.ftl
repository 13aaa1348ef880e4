network-covariance_not_positive = Réseau { $network } de coordinates.csv : la matrice de covariance des { $n } points n'est pas définie positive.

network-point_given_twice = Le point { $point } figure dans coordinates.csv (réseau { $network }) et comme appui avec écarts-types dans points.csv.
