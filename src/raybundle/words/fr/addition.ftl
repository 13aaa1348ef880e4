addition-camera_not_supported = Caméra { $camera } : l'effet d'une photo supplémentaire ne peut pas être prédit.

addition-camera_without_photograph = La caméra { $camera } n'a aucune photo qui participe.
