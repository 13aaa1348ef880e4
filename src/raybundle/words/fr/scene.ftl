scene-orientation_given = Image { $image } : scène satellite ; son orientation est dans le fichier de la scène.

scene-second_image = Caméra { $camera } : scène satellite, a déjà une image.

scene-size_unknown = Le fichier de la scène ne contient pas la taille de l'image.

scene-no_rpc = { $scene } n'a pas de RPC.

scene-no_rigorous_model = { $scene } n'a pas de modèle rigoureux pris en charge.

scene-file_gone = Caméra { $camera } : le fichier de sa scène ({ $scene }) manque ; le bloc ne peut être écrit.

scene-companion_gone = Caméra { $camera } : { $scene } renvoie à ce fichier, qui manque.

scene-length_unit = Les scènes satellitaires demandent length_unit = "m", pas "{ $unit }".
