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
