empirical-no_additional_parameter = { $model } : { $names } ne peut pas être exclu.

empirical-too_few_points = { $model } : { $object } points objet et { $image } points image ; il faut { $least } paires.

empirical-not_determined = { $model } : ces points ne déterminent pas ses { $n } paramètres.

empirical-no_minimum = { $model } : pas de minimum après { $n } itérations.

empirical-unknown_model = Le modèle empirique { $name } est inconnu.

empirical-none_fitted = Aucun modèle empirique ne peut être ajusté.

empirical-excluded_needs_model = { OPTION("without") } demande un modèle précis.

empirical-no_redundancy = { $model } : pas de redondance ; l'ajustement ne peut pas être jugé.

empirical-adequate = { $model } : des résidus de { $x_px } ; { $y_px } px (rms) concordent avec un sigma de { $sigma_px } px.

empirical-not_adequate = { $model } ne convient pas à cette scène : résidus de { $x_px } ; { $y_px } px (rms).

empirical-none_adequate = Aucun modèle ne convient ; le plus proche est { $model } : { $left_out_px } px (rms) aux coordonnées exclues.

empirical-advised = { $model } convient avec { $n } paramètres : { $left_out_px } px (rms) aux coordonnées exclues.
