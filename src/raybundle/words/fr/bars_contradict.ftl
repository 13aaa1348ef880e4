bars_contradict = Des règles se contredisent ({ P($p) }) : { $names }.

bars_contradict-exchanged = Des règles se contredisent ; avec les longueurs de { $first } et { $second } échangées, elles concordent.

bars_contradict-one = La règle { $names } contredit les autres ({ P($p) }), qui concordent.

bars_contradict-bar = { $bar } : donnée { NUM($given_mm, digits: 8) } mm, selon les autres { NUM($measured_mm, digits: 8) } mm.
