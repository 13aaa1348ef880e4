next_photograph-camera = Caméra { $camera } :
