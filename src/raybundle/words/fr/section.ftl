section-outside = La ligne { $number } est hors de la grille d'altitudes.

section-too_many_places = La ligne { $number } aurait { $n } points ; { $most } au plus sont possibles.

section-beyond_end = { $name } mesure { NUM($length, digits: 6) } ; { OPTION("between") } a un point à { NUM($at, digits: 6) }.

section-same_place = { OPTION("between") } a deux fois le point { NUM($at, digits: 6) }.

section-no_height = { $name } n'a pas d'altitude à { NUM($at, digits: 6) } { $unit } (X { NUM($x, digits: 8) }, Y { NUM($y, digits: 8) }), ni ailleurs.

section-no_height_at = { $name } n'a pas d'altitude à { NUM($at, digits: 6) } { $unit } (X { NUM($x, digits: 8) }, Y { NUM($y, digits: 8) }).

section-partly_measured = { $name } : l'altitude moyenne est celle de { PERCENT($share) } % de la ligne.
