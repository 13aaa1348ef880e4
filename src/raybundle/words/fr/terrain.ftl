terrain-flight_beyond = Le vol atteint { NUM($x, decimals: 1) } ; { NUM($y, decimals: 1) }, hors de la grille d'altitudes.

terrain-void_below_flight = La grille n'a pas d'altitude à { NUM($x, decimals: 1) } ; { NUM($y, decimals: 1) }, sous le vol ({ $n } endroits).
