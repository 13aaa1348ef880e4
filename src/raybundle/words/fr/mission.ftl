mission-no_crs = La mission a des coordonnées locales ; un drone demande des positions terrestres.

mission-vehicle_unknown = Le drone { $vehicle } est inconnu.

mission-camera_missing = La caméra manque.

mission-camera_unknown = La caméra { $camera } n'est ni un fichier ni une caméra connue.

mission-no_folder = Le fichier n'a pas de dossier de points de passage.

mission-no_way_point = La mission n'a aucun point de passage.

mission-no_height = La hauteur au-dessus du décollage manque.

mission-height_reference = Les hauteurs se rapportent à { $reference } ; il faut { $needed }.

mission-no_table = Le fichier n'a pas de [way_points] ; ce n'est pas un plan de vol.

mission-columns = Les colonnes des points de passage diffèrent.

mission-line_unknown = La ligne de vol { $line_number } n'existe pas ; { $n } sont définies, à partir de 0.

mission-unknown_pattern = Le motif { $pattern } est inconnu.

mission-area_in_zones = Les zones interdites couvrent toute la zone de la mission.

mission-too_many_photographs = La mission demande { $n } photos ; le maximum est { $most }.

mission-line_no_extent = Tous les points de la ligne sont identiques.

mission-speed_of_vehicle = Une vitesse de { $speed_mps } m/s dépasse les { $most_mps } m/s de { $vehicle }.

mission-camera_interval = La caméra { $camera } demande { $interval_s } s entre deux photos ; la mission prévoit { NUM($needed_s, decimals: 2) } s.

mission-battery = { $flight_line } est hors de portée d'une batterie : l'aller-retour dure { NUM($needed_min, decimals: 1) } min.

mission-no_stop = Le point de passage { $waypoint } démarre des photos, mais aucun suivant ne les arrête.

mission-no_photographs = La mission n'a aucune photo.

mission-base_not_positive = Point de passage { $waypoint } : la base entre photos est { $base_m } m.

mission-too_many_on_line = Le point de passage { $waypoint } démarre { $n } photos, une tous les { $base_m } m ; le maximum est { $most }.

mission-view_to_horizon = Une visée inclinée de { NUM($tilt_deg, decimals: 0) }° avec { NUM($angle_deg, decimals: 0) }° de champ atteint l'horizon.

mission-too_many_parts = La mission demande { $n } { $kind ->
        [lines] lignes
        [rows] rangées
       *[photographs] photos
     } ; le maximum est { $most }.

mission-heights_missing = Les hauteurs de l'objet au-dessus du sol manquent.

mission-heights_order = Le haut de l'objet, { $top_m } m, n'est pas au-dessus du bas, { $low_m } m.

mission-vehicle_not_positive = Véhicule { $vehicle } : { $entry } vaut { $value }.

mission-way_in_zone = Un trajet { $end ->
        [begins] commence
       *[ends] finit
     } dans une zone interdite, à { NUM($x, decimals: 1) } ; { NUM($y, decimals: 1) }.

mission-no_way = Aucun trajet de { NUM($x, decimals: 1) } ; { NUM($y, decimals: 1) } à { NUM($to_x, decimals: 1) } ; { NUM($to_y, decimals: 1) } n'évite les zones interdites.

mission-name = { $name } n'est pas possible comme nom de fichier.

mission-gsd_too_large = { OPTION("gsd", $gsd_m) } : ce pixel demande une distance de { NUM($distance_m, decimals: 0) } m (limite { NUM($limit_m, decimals: 0) } m).

mission-shape = Le motif { $pattern } demande { $wanted ->
        [area] un polygone
        [line] une ligne
       *[place] un point ou un polygone
     } ; { $area } contient { $kind ->
        [area] des polygones
        [line] des lignes
       *[place] des points
     }.

mission-several_outlines = { $area } contient { $n } contours ; une mission en a un.

mission-blur = À { $speed } m/s et 1/{ $exposure } s, l'image bouge de { NUM($blur, decimals: 1) } px (limite { $limit } px).

mission-zones_taken_out = Les zones interdites suppriment { $kind ->
    [metres] { NUM($metres, decimals: 0) } m de lignes
    *[photographs] { $n ->
        [one] une photo
        *[other] { $n } photos
    }
 }.

mission-speed_limited = { $limit ->
    [camera_interval] L'intervalle de la caméra
    *[blur] Le flou de bougé
 } limite la vitesse à { NUM($speed, decimals: 1) } m/s (véhicule : { $vehicle } m/s).

mission-ground_too_steep = Le terrain est plus raide que ne monte le véhicule à { NUM($speed, decimals: 1) } m/s : jusqu'à { NUM($raised, decimals: 1) } m trop haut.

mission-too_high = Les photos sont jusqu'à { NUM($height_m, decimals: 0) } m au-dessus du sol ; { $limit_m } m sont permis{ $open_category ->
        [yes] {" "}(UE 2019/947, catégorie ouverte)
        *[no] {""}
    }.

mission-out_of_sight = Le vol s'éloigne jusqu'à { NUM($distance_m, decimals: 0) } m du décollage ; la vue directe porte à { $limit_m } m.

mission-battery_exceeded = Un vol dure { NUM($minutes, decimals: 1) } min ; { NUM($usable, decimals: 1) } min d'une batterie sont utilisables.

mission-interval_short = L'intervalle des photos est de { NUM($interval_s, decimals: 2) } s ; l'appareil { $camera } demande { $needed_s } s.

mission-rolling_motion = Pendant la lecture d'une image, l'obturateur roulant se déplace de { NUM($motion_px, decimals: 1) } px au sol.

mission-seen_rarely = { NUM(PERCENT($share), decimals: 1) } % de la zone est sur moins de { $photographs } photos.

mission-overlap_low = Le recouvrement { $direction ->
        [along] longitudinal
        *[across] latéral
    } n'est que de { PERCENT($overlap) } % ; { PERCENT($asked) } % sont demandés.

mission-holes_flown_over = Les trous de la zone sont survolés.

mission-ground_holes = { $n } { $n ->
        [one] trou
        *[other] trous
    } dans les altitudes du sol, { NUM(PERCENT($share), decimals: 1) } % de la zone ; les recouvrements y sont inconnus.

mission-too_many_way_points = { $name } a { $n } points de passage ; { $program } en accepte { $most }.
