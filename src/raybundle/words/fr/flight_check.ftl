flight_check-no_positions = Aucune des photos n'a de position.

flight_check-other_place = Aucune photo n'est à un endroit prévu par la mission { $mission } ; l'écart moyen est de { NUM($away_m, decimals: 0) } m.

flight_check-no_crs = La mission a des coordonnées locales ; les photographies ont des positions sur la Terre.

flight_check-blurred = Photos floues, non comptées : { $names }.

flight_check-tilted = Photos trop inclinées, non comptées : { $names }.
