library-not_determinable = Les photographies n'ont pas déterminé cette caméra ; elle n'est pas ajoutée à la bibliothèque.

library-no_key = La bibliothèque demande le modèle de caméra et la focale EXIF ; il en manque un.
