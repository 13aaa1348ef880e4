scene-orientation_given = Image { $image } : scène satellite ; son orientation est dans le fichier de la scène.

scene-second_image = Caméra { $camera } : scène satellite, a déjà une image.

scene-size_unknown = Le fichier de la scène ne contient pas la taille de l'image.

scene-no_rpc = { $scene } n'a pas de RPC.

scene-no_rigorous_model = { $scene } n'a pas de modèle rigoureux pris en charge.

scene-file_gone = Caméra { $camera } : le fichier de sa scène ({ $scene }) manque ; le bloc ne peut être écrit.

scene-companion_gone = Caméra { $camera } : { $scene } renvoie à ce fichier, qui manque.

scene-length_unit = Les scènes satellitaires demandent length_unit = "m", pas "{ $unit }".

scene-file_elsewhere = { $name } n'est pas le nom d'un fichier dans le dossier de ce fichier.

scene-keys_exclusive = Cette clé et { $other } s'excluent.

scene-crs_superfluous = La table a longitude et latitude, qui n'exigent pas de système de coordonnées.

scene-crs_missing = Le système de coordonnées des positions X, Y, Z manque.

scene-format_unknown = Le format de la scène satellite est inconnu.

scene-pixel_count = { NUM($value, digits: 6) } n'est pas un nombre possible de pixels.

scene-position_count = Positions de l'orbite : { $n } ; il en faut au moins { $least }.

scene-attitude_count = Attitudes : { $n } ; il en faut au moins { $least }.

scene-not_an_orbit = Une position est à { NUM($distance_m, digits: 6) } m du centre de la Terre (limites { $least_m } à { $most_m } m).

scene-no_look_angles = Les directions de visée ({ $element }) manquent.

scene-no_picture = La scène n'a pas d'image.

scene-look_angle_count = Directions de visée : { $n } ; l'image a { $columns } colonnes.

scene-detector_order = Le détecteur { NUM($number, digits: 6) } n'est pas à sa place : la table a une lacune.

scene-same_time = Deux positions ont le même temps.

scene-models_contradict = { $scene } : le modèle rigoureux et le RPC diffèrent de { $meets ->
     [yes] { NUM($rms_px, digits: 4) } px (moyenne quadratique)
     *[no] plus que l'image
    }, limite { $limit_px } px.

scene-rpc_preferred = Seul le RPC est utilisé : le modèle rigoureux diffère de { $meets ->
     [yes] { NUM($rms_px, digits: 4) } px (moyenne quadratique)
     *[no] plus que l'image
    }, limite { $limit_px } px.

scene-no_geometry = Le fichier ne contient ni RPC ni modèle rigoureux utilisable.

scene-rpc_range_adapted = Le RPC a été récrit pour l'étendue de cette image, une partie de scène.

scene-one_band = La scène a { $n } bandes ; les directions de visée de la bande { $band } sont utilisées.
