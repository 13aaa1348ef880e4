calibration-no_list = { $value } n'est pas une liste de paramètres étalonnés.

calibration-incomplete_entry = L'entrée { $number } n'est pas un paramètre étalonné.

calibration-correlation_count = L'entrée { $number } a { $n } corrélation(s) ; il en faut { $needed }.

calibration-not_positive_definite = Les corrélations ne forment pas une matrice définie positive.

calibration-format_differs = Étalonnage { $camera } : aucune photographie n'a son format, { $width_px } x { $height_px } px.

calibration-several_cameras = L'étalonnage { $camera } convient à { $n } caméras.

calibration-two_for_camera = Deux étalonnages conviennent à la caméra { $camera }.
