trajectory-no_attitudes = La trajectoire n'a pas d'attitudes.

trajectory-attitude_reference = Les attitudes se rapportent { $true_north ->
        [yes] à la grille
       *[no] au nord vrai
     } ; il faut { $true_north ->
        [yes] le nord vrai
       *[no] la grille
     }.

trajectory-format_unknown = Le format du fichier n'est pas reconnu.

trajectory-count_differs = Positions sans nom : { $positions } ; photographies : { $photographs }.

trajectory-position_twice = La position { $name } appartient à { $first } et à { $second }.

trajectory-no_photograph_found = Aucune des { $n } photographies n'a de position ici.

trajectory-needs_local_frame = Les positions sont en longitude et latitude ; il faut un repère local.

trajectory-north_needs_frame = Les attitudes par rapport au nord vrai demandent un système de coordonnées.

trajectory-no_crs = Le fichier a des coordonnées de grille sans système de coordonnées.

trajectory-no_position = Le fichier ne contient aucune position.
