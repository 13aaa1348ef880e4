colmap-blank_in_name = Image { $image } : un espace dans le nom n'est pas possible dans les fichiers texte de COLMAP.

colmap-no_model = Le dossier ne contient pas de modèle COLMAP.

colmap-file_missing = Le fichier manque ; { $other } en a besoin.

colmap-camera_line = Une caméra demande numéro, modèle, largeur, hauteur et paramètres.

colmap-image_line = Une image demande numéro, 4 + 3 nombres, caméra et nom.

colmap-image_points_line = La ligne des points image a { $n } nombres ; chaque point en demande trois : x, y et numéro du point.

colmap-point_line = Un point demande numéro, 3 coordonnées, 3 couleurs et une erreur.
