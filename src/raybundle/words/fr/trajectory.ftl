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

trajectory-count = Table { $table } : { $times } temps et { $n } entrées.

trajectory-not_finite = La table { $table } a un temps ou une valeur qui n'est pas un nombre fini.

trajectory-time_order = Table { $table } : le temps { $time_s } s (entrée { $entry }) suit { $before_s } s.

trajectory-zero_quaternion = Un quaternion de l'attitude est de longueur nulle.

trajectory-not_covered = La table { $table } couvre { $start_s } à { $end_s } s, mais les lignes { $first_s } à { $last_s } s.

trajectory-gap = La table { $table } a une lacune de { $gap_s } s dans l'image, de { $start_s } à { $end_s } s.

trajectory-degree = { $name } = { $degree } n'est pas possible.

trajectory-parameter_count = Les paramètres de correction sont de forme ({ $shape }) ; il en faut { $needed }.

trajectory-velocity_contradicts = Table { $table }, entrée { $entry } : vitesse { NUM($stated, digits: 4) } m/s ; les positions changent de { NUM($moved, digits: 4) } m/s.

trajectory-undecided = Le fichier ne détermine pas la convention de ces colonnes : { $readings } sont possibles.

trajectory-scenes_apart = Les scènes d'une trajectoire sont séparées de { NUM($seconds, digits: 4) } s ; { NUM($limit_s, digits: 3) } s sont possibles.

trajectory-no_scene = Aucune caméra ne nomme la trajectoire { $name }.
