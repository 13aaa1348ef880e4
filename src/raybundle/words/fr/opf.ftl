opf-file_count = Le dossier a { $n } fichiers .opf ; il en faut un seul.

opf-not_calibrated = Le projet n'a pas de { $part }.

opf-path_outside = { $path } sort du dossier du projet.

opf-unknown_camera = Caméra { $camera } ou son capteur { $sensor } : absent des listes.

opf-counts_differ = { $points } points, { $ranges } plages et { $image_points } points image ne concordent pas.

opf-accessor_type = L'accesseur a le type { $kind } de { $type } ; il en faut un autre.

opf-accessor_size = L'accesseur annonce { $n } éléments ; son tampon a { $size_bytes } octets.

opf-ranges_overlap = Les plages de points image se recouvrent.

opf-not_finite = Une coordonnée n'est pas finie.
