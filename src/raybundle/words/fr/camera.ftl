camera-panorama_not_supported = Caméra { $camera } : ce format n'a pas de modèle de panorama tournant.

camera-no_lens = Caméra { $camera } : c = { $c_mm } mm et A = { $A } ne sont pas une orientation interne valable.

camera-distortion_not_invertible = { $name } : la distorsion n'est inversible que sur { PERCENT($covered) } % du format.

camera-wider_than_projection = { $name } voit à 89° ou plus de son axe.

camera-opencv_deviation = Caméra { $camera } : le modèle d'OpenCV à { $n } coefficients s'écarte de { NUM($deviation_px, digits: 2) } px au plus.

camera-opencv_coefficients = OpenCV n'a pas de modèle à { $n } coefficients.
