

flight_check-no_positions = Aucune des photos n'a de position.

flight_check-other_place = Aucune photo n'est à un endroit prévu par la mission { $mission } ; l'écart moyen est de { NUM($away_m, decimals: 0) } m.

flight_check-no_crs = La mission a des coordonnées locales ; les photographies ont des positions sur la Terre.

flight_check-ground_of_plan = Le plan suivait { $terrain }, qui manque ; ses hauteurs prévues définissent le sol.

flight_check-some_unplaced = { $n } photos sur { $of } n'ont pas de position ({ $example }, ...) ; elles ne comptent pas.

flight_check-not_decoded = { $n } { $n ->
        [one] photo illisible
        *[other] photos illisibles
    } ({ $example }, ...).

flight_check-blurred = Photos floues, non comptées : { $names }.

flight_check-tilted = Photos trop inclinées, non comptées : { $names }.
