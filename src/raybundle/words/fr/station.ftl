station-velocity_unknown = Le décalage de temps dt demande la vitesse de chaque image ; elle manque pour { $images }.

station-shared_with_parameters = L'image { $image } partage sa station et a des paramètres propres (caméra { $camera }).

station-orientations_differ = Les images { $images } partagent une station mais n'ont pas la même orientation externe.

station-partly_held = Les images { $images } partagent une station et seules certaines sont fixes.
