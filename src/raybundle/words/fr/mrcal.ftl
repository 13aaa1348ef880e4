mrcal-no_dictionary = Ce n'est pas un fichier .cameramodel ; il n'a pas de dictionnaire.
