camera-panorama_not_supported = Caméra { $camera } : ce format n'a pas de modèle de panorama tournant.

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
