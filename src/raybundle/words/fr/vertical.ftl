vertical-unknown_way = { OPTION("up") } vaut { $way }.

vertical-point_without_place = { OPTION("up") } : le point { $point } n'a pas de coordonnées.

vertical-same_place = { OPTION("up") } : les points { $first } et { $second } sont au même endroit.

vertical-no_plumb_line = { OPTION("up", $way) } : le bloc n'a pas de fil à plomb mesuré avec deux points.

vertical-way_unknown = { OPTION("up", $way) } n'est pas possible.

vertical-points_coincide = { OPTION("up", $way) } : les points sont au même endroit.
