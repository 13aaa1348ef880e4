

plan-not_sharp = { $kind ->
        [sheet] La feuille qui remplit le format
        [facade] La façade pour couples stéréo
        [turntable] L'objet sur sa table tournante
       *[building] Le bâtiment
     } à { $distance_m } m est flou (net : { $near_m } à { $far_m } m).

plan-no_flat_sheet = Une liste d'étalonnage demande une feuille plane ou une mire.

plan-no_footprint = L'objet n'a pas d'emprise : vu d'en haut, c'est une ligne ou un point.

plan-ring_too_far = L'anneau de stations est à { $distance_m } m des murs ; { $reach_m } m sont disponibles.

plan-height_not_shown = La hauteur de { $height_m } m demande { $distance_m } m de recul en format portrait ; { $reach_m } m sont disponibles.

plan-no_stereo_overlap = Côté { $side } : les deux photos d'un couple à { $distance_m } m ne se recouvrent pas.

plan-stations_missing = Les stations des photos manquent ; les cibles sont placées pour elles.

plan-too_few_target_places = { $n } endroits de l'objet sont visibles de { $rays } des { $stations } stations ; il en faut 4.

plan-targets_too_large = Chaque cible demande { NUM($size_mm, decimals: 0) } mm ; l'objet offre { NUM($space_mm, decimals: 0) } mm pour chacune.

plan-turn_too_large = { $n } pas par tour font { NUM($step_deg, decimals: 0) }° chacun ; le recouvrement est insuffisant.

plan-no_place_for_bars = Aucune paire de points dégagée n'est distante de { $length_m } m, la longueur d'une barre d'échelle.

plan-no_station_allowed = Aucune des { $n } positions testées n'est permise pour une station.

plan-object_not_seen = Aucune des { $n } positions permises ne voit { $least } points de l'objet.

plan-station_not_allowed = La station { $station } est hors limites, trop proche de l'objet ou dans une boîte interdite.

plan-points_not_adjusted = { $n ->
        [0] Aucun point n'est donné
       *[other] Points absents de la compensation : { $names }
     }.

plan-camera_fixed = Caméra { $camera } : aucun paramètre n'est estimé.

plan-too_few_control = { $n } points d'appui ne définissent pas de datum ; il en faut { $least }.

plan-control_not_sufficient = { $n } points d'appui ne déterminent pas le datum de ce réseau.

plan-mission_pattern = La précision d'une mission de motif { $pattern } ne peut pas être prédite.

plan-aim_no_sigma = L'objectif { $aim } n'est pas un écart-type.

plan-no_goal = Le plan n'a ni écart-type voulu ni nombre de stations.

plan-points_rarely_found = Les points de ce type sont détectés si rarement que le réseau de { $n } stations échoue souvent.

plan-nothing_seen_again = Aucune des { $n } stations possibles ne voit { $least } points du bloc.

plan-too_few_candidates = { $n } stations possibles voient assez de points ; { $wanted } photos sont demandées.

plan-no_object_points = La compensation n'a aucun point objet qu'une photo pourrait montrer.

plan-unknown_camera = Le bloc n'a pas de caméra { $camera }.

plan-no_frame_camera = La caméra { $camera } ({ $model }) n'est pas une caméra à image plane avec stations individuelles.

plan-camera_not_used = La caméra { $camera } n'a pas de photo dans la compensation.

plan-object_elsewhere = Objet { $name } : la moitié des points sont à plus de { $off } de sa surface (limite { $limit }).

plan-not_oriented = Le bloc { $block } a des photos sans orientation.

plan-photograph_not_oriented = La photo { $image } du bloc { $block } n'a pas d'orientation.

plan-no_common_interior = La caméra { $camera } n'a pas d'orientation interne commune à ses photos.

plan-no_station_within = Aucune des { $n } stations n'est dans les limites.

plan-one_place = Des photos d'un seul endroit ne peuvent pas être comparées à la liste.

plan-other_list = Les stations de ces photos concordent avec la liste en { $n } de { $total } endroits au plus.

plan-too_few_visible = { $n } des { $total } points de l'objet sont visibles depuis { $least } { $given ->
        [yes] des stations données
       *[no] stations possibles
     }.

plan-no_network_sees_all = Aucun réseau de { $most } stations au plus ne voit chaque point { $least } fois.

plan-beyond_reach = Un écart-type de { $wanted_mm } mm n'est pas possible : { $n } stations atteignent { $reached_mm } mm.

plan-station_sees_too_few = La station { $station } voit { $n } des { $total } points de l'objet ; son orientation en demande { $least }.

plan-too_few_rays = Avec { $stations } stations, { $n } des { $total } points de l'objet ont moins de { $least } rayons.

plan-not_determined = Un réseau de { $stations } stations ne détermine pas toutes les inconnues.

plan-list_count = La liste a { $n } photographies, le plan { $planned }.

plan-list_missing = La liste imprimée manque.

plan-list_edges = Les arêtes de l'objet manquent ou n'ont pas deux extrémités.

plan-station_at_itself = Une station a sa propre position pour point de visée.

plan-never_sharp = Les photographies sont nettes à partir de { $near_m } m ; les stations sont à { $far_m } m au plus.

plan-points_and_aim = { OPTION("points") } va avec { OPTION("aim", "worst") }.

plan-no_improvement = Aucune des { $n } stations possibles ne réduit un écart-type.

plan-focus_without_scale = { OPTION("focus") } demande l'échelle du bloc, qui n'est pas déterminée.

plan-unknown_list = Il n'y a pas de liste du type { $kind }.

plan-point_missing = Le point { $point } du bloc du plan manque.

plan-flight_too_large = Le vol a { $total } photographies ; les prévisions sont possibles jusqu'à { $most }.

plan-list_alike_turned = La liste est la même après une rotation : les photos sont attribuées dans leur ordre.

plan-list_most_beside = { $n } photos sur { $of } ne sont pas dans la liste.

plan-list_most_missing = { $n } photos de la liste sur { $of } manquent.

plan-nothing_lowers = { $n } photos sur { $wanted } proposées : aucune autre à portée n'abaisse la valeur.

plan-hardly_lowers = Les photos à portée n'abaissent la valeur que de { PERCENT($share) } %.

plan-points_out_of_sight = { $n } points sur { $of } sont visibles de moins de { $rays } stations possibles ({ $sides }).

plan-object_between_points = { PERCENT($share) } % de l'objet, entre les points, est vu par moins de deux photos.

plan-points_seldom_found = { PERCENT($share) } % des points sont attendus dans moins de deux photos.

plan-network_falls_apart = Dans { PERCENT($share) } % des tirages, le réseau se désagrège.

plan-little_overlap = Le recouvrement longitudinal est de { PERCENT($overlap) } %.

plan-gaps_between_lines = Des lacunes restent entre les bandes (recouvrement latéral { PERCENT($overlap) } %).

plan-flown_apart = Volées exactement comme prévu, les photos ne forment pas un bloc.

plan-flown_lost = Volés exactement comme prévu, des paramètres ne sont pas déterminables : { $parameters }.

plan-flown_calibrated = Aucune modification du vol essayée ne les détermine.

plan-free_camera = Les écarts-types mesurés de points naturels étaient de { $low } à { $high } fois ceux du plan.

plan-other_camera = L'angle de champ est de { NUM($seen_deg, decimals: 0) } degrés ; { NUM($planned_deg, decimals: 0) } degrés étaient prévus.

plan-flight_undetermined = { $lost ->
        [yes] Ce vol ne détermine pas { $parameters }.
        *[no] Seule l'irrégularité du vol détermine { $parameters }.
    }
