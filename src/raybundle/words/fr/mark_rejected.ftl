mark_rejected = La mesure du point { $point } dans { $image } est à { NUM($off_px, decimals: 0) } px des autres et écartée.

mark_rejected-test = La mesure du point { $point } dans { $image } contredit les autres et est écartée.
