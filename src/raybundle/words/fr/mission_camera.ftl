mission_camera-not_positive = Caméra { $camera } : { $entry } vaut { $value }.
