point-number_invalid = { $number } n'est pas un numéro de point utilisable.

point-sigma_without_coordinate = Point { $point } : { $sigma } sans { $coordinate }.

point-tie_with_sigma = Point de liaison { $point } : a un écart-type.

point-control_without_sigma = Point d'appui { $point } : aucune coordonnée avec écart-type.

point-check_without_coordinate = Point de contrôle { $point } : aucune coordonnée.

point-sigma_out_of_range = Point { $point }, { $axis } : { $sigma } n'est pas un écart-type.

point-no_coordinate = Le point d'appui { $point } a un écart-type ({ $sigma }) mais pas de coordonnée { $axis }.

point-not_in_result = Absents du résultat ou sans coordonnées : { $names }.

point-window_too_large = La fenêtre { NUM($window, digits: 6) } du point { $point } est plus grande que l'étendue de tous les points, { NUM($extent, digits: 6) }.
