interior-shared = Caméra { $camera } : { $parameter } est commun à toutes les images.

interior-per_image_twice = interior = "per_image" comprend déjà tous les paramètres.
