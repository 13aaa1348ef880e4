axes-point_missing = Système de coordonnées : { $which ->
        [origin] l'origine
       *[axis] le point de l'axe
     } manque.

axes-same_points = Système de coordonnées : parmi les points { $names }, certains sont identiques.

axes-in_line = Système de coordonnées { $names } : les points sont alignés.

axes-vertical = Système de coordonnées { $names } : les points sont l'un au-dessus de l'autre.

axes-level_no_plane = Niveau { $names } : les { $n } points ne définissent pas de plan.

axes-no_coordinates = Système de coordonnées { $names } : le point { $point } n'a pas de coordonnées.

axes-contradicts_block = Le système de coordonnées des points { $names } contredit le datum du bloc ({ $tables }).

axes-no_vertical = Le système de coordonnées des points { $names } n'a pas de verticale.

axes-plane_or_level = Système de coordonnées : il faut soit un point du plan, soit les points d'un niveau.

axes-point_count = Points donnés : { $n } ; un système de coordonnées en demande trois, deux ou aucun.
