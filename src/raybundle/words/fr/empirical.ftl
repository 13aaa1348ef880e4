empirical-no_additional_parameter = { $model } : { $names } ne peut pas être exclu.

empirical-too_few_points = { $model } : { $object } points objet et { $image } points image ; il faut { $least } paires.

empirical-not_determined = { $model } : ces points ne déterminent pas ses { $n } paramètres.

empirical-no_minimum = { $model } : pas de minimum après { $n } itérations.

empirical-unknown_model = Le modèle empirique { $name } est inconnu.

empirical-none_fitted = Aucun modèle empirique ne peut être ajusté.

empirical-excluded_needs_model = { OPTION("without") } demande un modèle précis.
