kalibr-no_camera = Le fichier n'a pas de caméra cam0.
