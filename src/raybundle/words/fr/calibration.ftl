calibration-no_list = { $value } n'est pas une liste de paramètres étalonnés.

calibration-incomplete_entry = L'entrée { $number } n'est pas un paramètre étalonné.

calibration-correlation_count = L'entrée { $number } a { $n } corrélation(s) ; il en faut { $needed }.

calibration-not_positive_definite = Les corrélations ne forment pas une matrice définie positive.

calibration-format_differs = Étalonnage { $camera } : aucune photographie n'a son format, { $width_px } x { $height_px } px.

calibration-several_cameras = L'étalonnage { $camera } convient à { $n } caméras.

calibration-two_for_camera = Deux étalonnages conviennent à la caméra { $camera }.

calibration-size_differs = Caméra { $camera } : { $width_px } x { $height_px } px, non { $given_width_px } x { $given_height_px } px.

calibration-pixel_size = Une taille de pixel de { $pixel_mm } mm est impossible.

calibration-one_model = Le format { $format } n'a qu'un modèle de distorsion.

calibration-model_unknown = Le format { $format } n'a pas de modèle { $model }.

calibration-suffix = Le format { $format } est un fichier d'une autre extension.

calibration-deviation = Caméra { $camera } en { $model } : écart de { $deviation_px } px au plus (limite { $limit_px } px).

calibration-one_camera = Caméras à écrire : { $n } ; un fichier { $format } en contient une seule.

calibration-second_camera = Le fichier contient une deuxième caméra.

calibration-australis_row = Paramètre { $parameter } : { $n } nombres ; il en faut { $needed }.

calibration-incomplete = Le rapport d'étalonnage ne contient pas { $missing }.

calibration-impossible_values = Format { $width_px } x { $height_px } px, pixel { $pixel_mm } mm ou c = { $c_mm } mm : impossible.

calibration-no_size = Le fichier ne contient pas la taille de l'image.

calibration-pixels_not_square = Un format de { $width_mm } x { $height_mm } mm ne convient pas à { $width_px } x { $height_px } px (rapport { $ratio }).

calibration-no_camera = Le fichier ne contient aucune caméra.

calibration-size_or_distance = Format { NUM($width_px, digits: 8) } x { NUM($height_px, digits: 8) } px ou distance principale { $distance_px } px : impossible.

calibration-camera_count = Caméras dans ce fichier : { $n } ; il en faut une seule.

calibration-no_covariance = Ce n'est pas une matrice de covariance : elle doit être symétrique et définie positive.

calibration-format_unclear = Le fichier peut être de plusieurs formats d'étalonnage : { $names }.

calibration-format_not_recognised = Le fichier n'est pas reconnu comme étalonnage.

calibration-not_estimated = Caméra { $camera } : aucun paramètre de l'orientation interne n'a été estimé avec statistiques.

calibration-formats_differ = Des étalonnages de { $first_px } px et { $second_px } px ne peuvent pas être comparés.

calibration-cropped_format = { $width_px } × { $height_px } px n'est pas une réduction de { $camera_width_px } × { $camera_height_px } px.

calibration-used = Étalonnage : { $used } photographies sur { $of }, { $points } points.

calibration-grade = Caméra { $camera } : { $grade ->
        [not_determinable] non déterminable.
        [good] bonne
        [usable] utilisable
        *[other] faible
    }{ $grade ->
        [not_determinable] {""}
        *[other] , projection { NUM($typical_px, digits: 2) } px (médiane sur le format).
    }

calibration-photograph_next = Prendre { $n } photographies supplémentaires : liste avec { OPTION("verbose", "True") }.

calibration-several = Caméras dans ce fichier : { $n } ; aucune n'est nommée.

calibration-one_for_one = Caméras dans ce fichier : { $n } ; caméras des photographies : { $photographed }. Il en faut une de chaque.

calibration-no_camera_of_size = Caméras du fichier avec { $width_px } x { $height_px } px, la taille de la photographie : { $n } ; il en faut une.

calibration-too_few_photographs = { $n } photographies utilisables ; un étalonnage en demande au moins { $least }.

calibration-spline_parameters = Les paramètres du modèle spline ne peuvent pas être choisis.

calibration-too_few_points = { $n } des { $photographs } photographies montrent { $least } points communs de { $families } ; il en faut 2.

calibration-flat_views = Les vues de l'objet plan ne diffèrent que de { NUM($angle_deg, decimals: 0) }° ; il faut { NUM($least_deg, decimals: 0) }°.

calibration-not_possible = La caméra ne peut pas être étalonnée à partir de ces photographies.

calibration-spline_worse = Caméra { $camera } : le modèle spline finit moins bien ({ NUM($rms_px, digits: 2) } px) que le départ ({ NUM($start_rms_px, digits: 2) } px).

calibration-inverse_in_part = Caméra { $camera } : distorsion inversible sur { PERCENT($share) } % du format seulement.

calibration-file_unusable = { $name } n'est pas utilisable.

calibration-none_fits = Aucun étalonnage de la bibliothèque ne convient à { $name }.

calibration-validity = { $reason ->
        [none] La distorsion est inversible sur tout le format.
        *[other] La distorsion n'est inversible que jusqu'à { NUM($angle_deg, decimals: 1) }° de l'axe.
    }
