zoom-range = { $range_mm } mm, résolution { $resolution_mm } mm : pas une plage de focales.

zoom-coefficient_count = Coefficients : { $n } ; de 1 à { $most } possibles.
