camera-panorama_not_supported = La caméra { $camera } est un panorama tournant ; cette étape ou ce format ne peut pas l'utiliser.

camera-no_lens = Caméra { $camera } : c = { $c_mm } mm et A = { $A } ne sont pas une orientation interne valable.

camera-distortion_not_invertible = { $name } : la distorsion n'est inversible que sur { PERCENT($covered) } % du format.

camera-wider_than_projection = { $name } voit à 89° ou plus de son axe.

camera-opencv_deviation = Caméra { $camera } : le modèle d'OpenCV à { $n } coefficients s'écarte de { NUM($deviation_px, digits: 2) } px au plus.

camera-opencv_coefficients = OpenCV n'a pas de modèle à { $n } coefficients.

camera-not_in_format = Caméra { $camera } : { $kind ->
        [scene] une scène satellite
       *[fisheye] un fisheye
     } ne peut être représentée en { $format }.

camera-constant_unknown = Caméra { $camera } : la constante de caméra est inconnue.

camera-format_size = Caméra { $camera } : un format de { $width_px } x { $height_px } px est impossible.

camera-equirectangular_size = Caméra { $camera } : les paramètres { $parameters } diffèrent du format { $width_px } x { $height_px } px.

camera-principal_distance = Caméra { $camera } : la distance principale est { $fx_px }, { $fy_px } px.

camera-parameter_limits = Caméra { $camera } : { $parameter } du modèle { $model } vaut { $value }, hors de { $least } à { $most }.

camera-model_unknown = Caméra { $camera } : le modèle { $model } n'est pas pris en charge.

camera-parameter_count = Caméra { $camera } : { $n } paramètres donnés ; le modèle { $model } en a { $needed }.

camera-pixel_size_missing = La largeur et la hauteur d'un pixel sont nécessaires.

camera-pattern_without_photograph = Aucune photographie ne correspond au motif { $pattern } d'une caméra.

camera-two_patterns = La photographie { $photograph } correspond à deux motifs, { $first } et { $second }.

camera-no_turned_copy = Le format de la caméra { $camera } n'est pas celui de { $other } tourné de { $turned_deg }°.

camera-scans_not_transformed = Caméra { $camera } : ses fichiers sont des scans non transformés dans le repère de la caméra.

camera-turned_only_brown = Caméra { $camera } : les photos tournées demandent le modèle brown, pas { $model }.

camera-covariance_not_positive = Caméra { $camera } : la covariance de son étalonnage n'est pas définie positive.

camera-unknown_scene_parameter = Caméra { $camera } : cette scène n'a pas de paramètre { $name }.

camera-not_in_block = La caméra { $camera } n'est pas dans le bloc.

camera-no_parameter = La caméra { $camera } n'a pas de paramètre { $name }.

camera-constant_missing = Caméra { $camera } : la distance principale { $parameter } est 0 ; le modèle { $model } demande une valeur.

camera-several = Le résultat a { $n } caméras et aucune n'est nommée.

camera-symbols_unknown = Caméra { $camera } : le modèle { $model } n'a pas de paramètre { LIST($names, most: 3) }.

camera-unknown = Il n'y a pas de caméra { $camera }.

camera-interior_per_image = Caméra { $camera } : chaque image a sa propre orientation interne.

camera-no_interior_of_image = Caméra { $camera } : l'image { $image } n'a pas d'orientation interne propre.

camera-no_ray = Caméra { $camera } : avec ces paramètres, un point image n'a pas de rayon défini.

camera-parameters_of_image = Caméra { $camera } : le modèle { $model } n'a pas de paramètres propres aux images.

camera-too_many_turns = Caméra { $camera } : le format ({ NUM($width_mm, digits: 4) } mm) couvre { $turns } tours (limite { $limit }).

camera-no_read_out_time = Caméra { $camera } : le temps de lecture r est 0.

camera-no_motion = Caméra { $camera } : la vitesse vy est 0.

camera-no_covariance = La caméra { $camera } n'a pas de matrice de covariance.

camera-calibration_model_unknown = Le modèle de capteur { $model } est inconnu.

camera-not_by_targets = Le modèle de capteur { $model } ne peut pas être étalonné par des photographies de cibles.

camera-model_not_fitted = Caméra { $camera } : le modèle { $model } ne s'ajuste pas aux valeurs approchées.

camera-trajectory_unknown = Le bloc n'a pas de trajectoire { $name }.

camera-mount_unknown = Le bloc n'a pas de monture { $name }.

camera-trajectory_of_lines = Seuls les scanners à lignes (model = "linescan") partagent une trajectoire ; { $name } a été nommée par une autre scène.

camera-instrument_missing = La caméra { $camera } prend des paramètres de { $name }, absent du bloc.
