picture-no_scale = L'échelle de l'image est inconnue : { $plane } et { $world } manquent.

picture-other_system = L'image est en { $picture }, le bloc en { $block ->
        [none] ses propres axes
        *[other] { $block }
    }.

picture-earlier_adjustment = L'image vient d'une compensation antérieure : { $photograph } a bougé de { $offset } { $unit }.

picture-suffix = Le nom de l'image ne finit pas par { LIST($known, most: 8) }.

picture-not_geotiff = L'image ne peut être écrite en GeoTIFF ({ $detail }).

picture-free_scale = L'échelle de cette image n'est pas déterminée ; un dessin en demande une.

picture-world_file_only = Un fichier world ne définit pas la position du plan dans l'espace.

picture-no_plane_points = Une photographie seule demande des points du plan.

picture-setting_of_other_source = { OPTION($setting) } concerne { $result ->
        [yes] un résultat
       *[no] une photographie seule
     }.

picture-not_readable = L'image ne peut pas être lue ({ $detail }).

picture-area_empty = Une zone de { $width } x { $height } avec un pixel de { $pixel } ne fait pas d'image.

picture-pixel_too_large = Un pixel de { $pixel } est plus grand que la zone de { NUM($width, digits: 4) } x { NUM($height, digits: 4) }.

picture-too_large = L'image aurait { $width_px } x { $height_px } px (limite { $limit_px } px).

picture-area_far_away = { OPTION($setting) } est loin des points du résultat.

picture-no_photograph = Aucune photographie ne montre la zone, ou aucune n'a été lue.

picture-control_on_line = Les points d'appui sont sur une droite (limite { PERCENT($limit) } % de sa longueur).

picture-area_not_shown = La photographie ne montre pas la zone.

picture-hidden_places = Les endroits cachés par des pentes ou des bâtiments ne sont pas détectés.

picture-few_points_in_plane = { PERCENT($share) } % des points sont dans ce plan.

picture-points_displaced = Points décalés dans l'image de { NUM($off, digits: 2) } { $unit } ({ NUM($pixels, digits: 2) } px) : ils sont hors du plan.

picture-residuals = Résidus de { NUM($x, digits: 3) }, { NUM($y, digits: 3) } px (rms), { NUM($sigma0, digits: 3) } fois plus grands que prévu ; maximum : { $worst }.

picture-no_redundancy = L'image repose sur le minimum de points : les erreurs ne sont pas décelées.

picture-mirrored = L'image est inversée.

picture-relief = Le relief déplace { PERCENT($share) } % des points du mur de plus de { NUM($limit, digits: 2) } { $unit } (limite { PERCENT($limit_share) } %).
    .why = Le mur s'étend de { NUM($back, digits: 2) } à { NUM($front, digits: 2) } { $unit } autour du plan ; l'image d'un seul plan le décale ou le dédouble de { NUM($displacement, digits: 2) } { $unit }.
    .do = Le dessiner par raybundle facade, ou accepter le déplacement : { OPTION("relief", "LENGTH") }.
