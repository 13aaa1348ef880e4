control_left_out = { $n } point(s) d'appui de { $name } contredisent les autres et sont exclus : { $ids }.

control_left_out-unsolvable = Tous les points d'appui ({ $n }) sont exclus : avec eux il n'y a pas de solution.
