distance_suspect-control = La règle { $name } contredit l'appui : { NUM($length, digits: 6) } { $unit } donnés, { NUM($shown, digits: 6) } { $unit } mesurés.

distance_suspect-far = La règle { $name } contredit les autres observations de plus de { PERCENT($share) } % de sa longueur.

distance_suspect-contradict = { $bars } barres d'échelle se contredisent : { LIST($ids, most: 5) }.

distance_suspect-factor = { $name } ({ NUM($given, digits: 6) } { $unit }) : facteur relatif { NUM($factor, digits: 5) }

distance_suspect-left_out = { $bars } barre(s) d'échelle contredisent toutes les autres observations et sont écartées : { LIST($ids, most: 5) }.

distance_suspect-bar = { $name } : { NUM($given, digits: 6) } { $unit } donnés, { NUM($shown, digits: 6) } { $unit } dans le bloc

distance_suspect-beside_control = La barre d'échelle { $start } - { $end } contredit les points d'appui et est écartée : facteur { NUM($ratio, digits: 4) }.
