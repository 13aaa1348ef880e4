vertical-unknown_way = { OPTION("up") } vaut { $way }.

vertical-point_without_place = { OPTION("up") } : le point { $point } n'a pas de coordonnées.

vertical-same_place = { OPTION("up") } : les points { $first } et { $second } sont au même endroit.
