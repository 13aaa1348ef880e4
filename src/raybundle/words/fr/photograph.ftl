photograph-empty = Le fichier est vide.

photograph-kind_unknown = Ce format d'image n'est pas pris en charge (il commence par { $begin }).

photograph-video = C'est une vidéo.

photograph-anymap = C'est un fichier PGM ou PPM sans métadonnées.

photograph-header_unreadable = L'en-tête de l'image est illisible ({ $detail }).

photograph-tiff_pixels = Un TIFF à { $bands } canal(aux) de { $bits } bits n'est pas pris en charge.

photograph-no_size = L'en-tête de l'image donne { $width_px } x { $height_px } px.

photograph-too_large = L'image a { $width_px } x { $height_px } px, { $megapixels } mégapixels (limite { $limit_megapixels }).

photograph-package_missing = Ce format demande un paquet supplémentaire.

photograph-bits = L'image a { $bits } bits par canal ; 8 et 16 sont pris en charge.

photograph-pixels_unreadable = Les pixels ne peuvent être décodés ({ $detail }).

photograph-pixels_16_bit = Les pixels de 16 bits ne peuvent être décodés.

photograph-copy = Le contenu est identique à { $original }.

photograph-too_small = L'image a { $width_px } x { $height_px } px, trop peu pour des mesures.

photograph-no_content = { $width_px } x { $height_px } px en { $size_bytes } octets : ce n'est pas une photographie.

photograph-thumbnail = L'image est une vignette de { $width_px } x { $height_px } px ; les autres ont { $typical_megapixels } mégapixels.

photograph-size_changed = L'image a { $width_px } x { $height_px } px ; son en-tête donne { $header_width_px } x { $header_height_px }.

photograph-changed = Le fichier a été remplacé pendant l'exécution.

photograph-none_oriented = Aucune photo n'est encore orientée.

photograph-lacks_fiducials = Scan { $image } : { $n } repères sont mesurés ; il en faut { $least }.

photograph-film_contradicts = Scan { $image } : ses repères ne concordent pas ({ $detail }).

photograph-lacks_marks = Photo { $image } : { $n ->
        [0] aucun point n'y est marqué
       *[other] aucun de ses { $n } points n'est marqué dans une autre photo
     }.

photograph-lacks_common = Les photos { $image } et { $other } ont { $n } points communs ; il en faut { $least }.

photograph-lacks_known = La photo { $image } montre { $n } points avec coordonnées ; il en faut { $least }.

photograph-lacks_base = Photos { $image } et { $other } : les rayons vers leurs { $n } points sont parallèles.

photograph-lacks_fit = Photo { $image } : aucune orientation ne convient à ses { $n } points.

photograph-size_of_calibration = La photographie a { $width_px } x { $height_px } px, l'étalonnage { $camera_width_px } x { $camera_height_px } px.

photograph-folder_unknown = Le dossier des photographies est inconnu.

photograph-too_few = Photographies dans ce dossier : { $n } ; il en faut deux.

photograph-none = Il n'y a pas de photographie ici.

photograph-other_size = Le fichier a { $width_px } x { $height_px } px, son image dans le bloc { $block_width_px } x { $block_height_px } px.

photograph-not_in_result = Absents du résultat : { $names }.

photograph-no_longer_readable = Des photographies sont devenues illisibles pendant l'exécution.

photograph-too_few_usable = { $n } photographies utilisables ; il en faut au moins { $least }.

photograph-in_no_folder = Le fichier n'est dans aucun des dossiers des photographies.

photograph-none_readable = Aucune photographie du bloc ne peut être lue.

photograph-map_raster = Une image matricielle à virgule flottante ({ $bits } bits) dans une carte contient des hauteurs, pas une photographie.

photograph-not_fetched = Le fichier n'a pas pu être obtenu en { $n } essais ({ $detail }).

photograph-unknown_scheme = Aucune photographie n'est lue par ce protocole.
