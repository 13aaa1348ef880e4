file-not_readable = Le fichier est illisible ({ $detail }).

file-missing = Ce fichier ou dossier n'existe pas.

file-memory = Le fichier demande plus de mémoire que disponible.

file-not_computable = Les nombres de ce fichier ne mènent à aucun résultat.

file-link_broken = Ce lien mène à { $target }, qui n'existe pas.

file-link_loop = Un lien de ce chemin renvoie à lui-même.

file-impossible_name = Ce nom de fichier est impossible.

file-not_a_file = C'est { $kind ->
        [folder] un dossier
        [pipe] un tube
        [socket] un socket
       *[device] un périphérique
     }, pas un fichier.

file-too_large = Le fichier a { $size_bytes } octets ; { $limit_bytes } au plus sont lus.

file-changed = Le fichier a changé pendant la lecture.

file-control_character = Le fichier contient le caractère de contrôle { $byte } ; ce n'est pas un texte.

file-not_utf8 = L'octet { $byte } n'est pas de l'UTF-8.

file-nested_too_deeply = Les valeurs sont imbriquées sur plus de { $most } niveaux.

file-number_too_long = Un nombre a trop de chiffres.

file-not_understood = Le contenu est incompréhensible ({ $detail }).

file-exists = Le fichier existe déjà.

file-is_a_folder = C'est un dossier.

file-not_writable = Écriture impossible ici ({ $detail }).

file-created_meanwhile = Une autre exécution a créé ce nom entre-temps ; ce résultat est abandonné.

file-no_images = Il n'y a pas d'images.

file-empty = Le fichier est vide.

file-suffix = Le nom doit se terminer par { LIST($known, most: 20) }.

file-name_not_utf8 = Ce nom n'est pas de l'UTF-8 valide.

file-read_by_command = Ce fichier est une entrée de la commande ; il n'est pas écrasé.

file-hdf5_damaged = Le fichier HDF5 est endommagé ou incomplet ({ $detail }).
