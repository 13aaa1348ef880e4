distance_suspect-control = La règle { $name } contredit l'appui : { NUM($length, digits: 6) } { $unit } donnés, { NUM($shown, digits: 6) } { $unit } mesurés.

distance_suspect-far = La règle { $name } contredit les autres observations de plus de { PERCENT($share) } % de sa longueur.
