join-one_block = Il faut au moins deux blocs à joindre.

join-too_few_common = { $name } et { $base } ont { $n } points communs avec coordonnées ; il en faut { $least }.

join-control_contradicts = Point { $point } : les coordonnées données dans { $name } et { $base } diffèrent de { $apart } { $unit } (limite { $limit } { $unit }).

join-vertical_tilted = Le repère de { $base } est incliné de { NUM($tilt_deg, digits: 2) }° par rapport à la verticale de { $name }.

join-cameras_differ = La caméra { $camera } de { $name } n'est pas celle du même nom dans l'autre bloc.

join-scale_of = Échelle de { $name } : { $kind ->
        [control] points d'appui
        [positions] positions observées
       *[bars] { $n } barre(s) d'échelle
     }.

join-scale_bar = { $start } - { $end } : { NUM($length, digits: 10) } { $unit }

join-same_measurement = Toutes les photographies de { $name } ({ $n }) ont les mêmes points d'image dans { $first } et { $second }.

join-same_photographs = { $n } photographies ont les mêmes points d'image dans { $first } et dans { $second } : { LIST($names, most: 3) }.

join-too_few_to_test = Aucun point commun n'est testé : { $name } et { $base } en ont moins de { $least }.

join-points_not_tested = Les points communs de { $name } ne sont pas testés :

join-block_not_adjusted = Aucun point commun n'est testé : { $name } ne peut pas être compensé seul :

join-points_moved = { $moved } des { $n } points communs de { $name } et { $base } ne sont pas le même point.

join-scales_not_tested = Les échelles de { $base } et { $name } ne sont pas comparées :

join-scales_contradict = Les longueurs de { $name } sont { NUM($factor, digits: 7) } ± { NUM($sigma, digits: 2) } fois celles de { $base }.

join-frames_contradict = { $name } et { $base } ne sont pas dans un même repère : décalage { NUM($shift_m, digits: 2) } m, rotation { NUM($turn_mrad, digits: 2) } mrad (F { $F }).

join-other_unit = Les longueurs de { $name } sont { NUM($factor, digits: 6) } fois celles de { $base }.

join-cameras_not_compared = Les caméras de { $name } et { $base } ne sont pas comparées :

join-camera_contradicts = La caméra { $camera } n'est pas la même dans { $base } et { $name } (limite { $limit } écarts-types).

join-camera_differs = La caméra { $camera } diffère significativement entre { $base } et { $name } (F { $F }).

join-dots_renumbered = Les points sans code sont renumérotés : { $n } communs par leur position, { $others } de { $names } ont de nouveaux numéros.

join-points_beyond_sigma = Les points communs stables de { $name } diffèrent plus que ne l'expliquent leurs écarts-types (F { $F }).

join-frame_of = Le repère est celui de { $name }, qui a { $control ->
        [yes] des appuis ou des positions
       *[no] une échelle
     }.

join-images_renamed = { $n } image(s) de { $name } ont un nouveau nom, comme { $example }.

join-cameras_renamed = Les caméras de { $name } sont traitées comme d'autres caméras : { LIST($ids, most: 9) } devient { LIST($renamed, most: 9) }.

join-other_frame = { $name } est transformé dans le repère de { $base }. Les origines sont distantes de { NUM($away_m, decimals: 3) } m.

join-point_incomplete = Il manque une coordonnée au point { $point } de { $block } ; il ne peut pas être transformé.

join-vertical_of_tables = Les verticales des repères diffèrent de { NUM($tilt_deg, digits: 2) }° (limite { NUM($limit_deg, digits: 2) }°).

join-frames_differ = { $block } ({ $unit }) et { $other } ({ $other_unit }) sont dans des repères qui ne se transforment pas l'un dans l'autre.

join-frame_projected = { $block } est en coordonnées de { $system }.

join-frame_geocentric = { $block } est dans un repère géocentrique.

join-frame_local = { $block } est dans un repère local à { NUM($longitude_deg, decimals: 6) }°, { NUM($latitude_deg, decimals: 6) }°, { NUM($height_m, decimals: 3) } m.

join-frame_of_system = { $block } est dans un repère local de { $system }.

join-points_apart = { $name } : des points de même nom sont distants et restent deux points : { $points }.

join-block = { $name } : { $frame ->
    [same] dans le même système
    *[moved] transformé par { $n } { $n ->
        [one] point commun
        *[other] points communs
    }, échelle { NUM($scale, digits: 6) }, écarts { NUM($rms, digits: 3) } { $unit } (rms)
 }.
