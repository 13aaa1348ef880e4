object_line-too_few_points = Objet { $name } : sa ligne a moins de deux points de deux coordonnées.

object_line-not_finite = Objet { $name } : le point { $point } de la ligne a une coordonnée qui n'est pas un nombre fini.

object_line-identical_points = Objet { $name } : les points { $first } et { $second } de la ligne sont identiques.

object_line-too_long = Objet { $name } : sa ligne mesure { $length_m } m, plus que { $largest_m } m.
