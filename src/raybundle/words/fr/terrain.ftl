terrain-flight_beyond = Le vol atteint { NUM($x, decimals: 1) } ; { NUM($y, decimals: 1) }, hors de la grille d'altitudes.

terrain-void_below_flight = La grille n'a pas d'altitude à { NUM($x, decimals: 1) } ; { NUM($y, decimals: 1) }, sous le vol ({ $n } endroits).

terrain-object_too_wide = { OPTION("largest", $largest) } dépasse la moitié du petit côté ({ NUM($side, digits: 4) }).

terrain-object_below_cell = { OPTION("largest", $largest) } est inférieur à une cellule ({ NUM($cell, digits: 6) }).

terrain-slope_too_large = { OPTION("slope", $slope) } monte de { $rise } par cellule ; les altitudes ne diffèrent que de { $range }.

terrain-no_ground = Aucune cellule ne reste comme sol.

terrain-spans_gaps = { PERCENT($share) } % de ce terrain est interpolé sur des lacunes.
