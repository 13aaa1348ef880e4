plane-points_in_line = Plan { $name } : ses points sont alignés.

plane-axes_not_orthogonal = right, up et normal ne forment pas un repère orthonormé (écart { $deviation }, limite { $limit }).

plane-place_unknown = La position du plan est inconnue : right, up et normal manquent.

plane-other_unit = L'unité du plan est { $plane }, celle du bloc { $block }.

plane-vertical_and_horizontal = Un plan ne peut pas être { OPTION("vertical", "True") } et { OPTION("horizontal", "True") }.

plane-too_few_points = Le plan a { $n } points ; il en faut { $least }.

plane-point_twice = Le point { $point } du plan est nommé deux fois.

plane-no_projected_system = { $system } n'est pas un système de coordonnées projeté ; une image en demande un.

plane-points_above_each_other = Les points du plan sont l'un au-dessus de l'autre ; un plan vertical n'a pas de direction.

plane-points_on_line = Les points du plan sont sur une droite.

plane-axis_no_direction = { OPTION("axis", $first, $second) } : vus dans le plan, les points sont l'un derrière l'autre.

plane-leans = Les points penchent { $back ->
        [yes] en arrière
        *[no] en avant
    } de { NUM($lean_deg, digits: 2) }{ $sigma_known ->
        [yes] {" "}± { NUM($sigma_deg, digits: 2) }
        *[no] {""}
    } degrés; aucun mur ne penche de plus de { NUM($limit_deg, digits: 2) } degrés.

plane-not_plumb = Le mur n'est pas d'aplomb : ses points penchent { $back ->
        [yes] en arrière
        *[no] en avant
    } de { NUM($lean_deg, digits: 2) }{ $sigma_known ->
        [yes] {" "}± { NUM($sigma_deg, digits: 2) }
        *[no] {""}
    } degrés.

plane-no_such_wall = Les points montrent { $n } murs, pas { $wall }.
    .do = Choisir { OPTION("wall") } plus petit, ou nommer des points du mur : { OPTION("plane", "A,B,C") }.
