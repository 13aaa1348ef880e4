rpc-not_of_rasterio = Un objet de type { $kind } n'est pas un RPC de rasterio ({ $detail }).

rpc-wrong_shape = RPC : { $name } est de forme ({ $shape }), ou a des valeurs qui ne sont pas finies.

rpc-not_positive = RPC : { $name } vaut { $values }.

rpc-centre_out_of_range = RPC : latitude { $latitude_deg }°, longitude { $longitude_deg }° du centre ne sont pas valables.

rpc-zero_denominator = RPC : le dénominateur { $axis ->
        [line] de ligne
       *[sample] de colonne
     } est nul au centre de la scène.

rpc-no_ground_point = Le point image ligne { NUM($image_line, decimals: 2) }, colonne { NUM($sample, decimals: 2) } n'a pas de point terrain à l'altitude { $height_m } m.

rpc-points_far_away = { $n } points sur { $total } sont loin hors de la scène ; le point { $point } l'est de { NUM($ratio, digits: 4) } fois son étendue.

rpc-small_denominator = RPC : le dénominateur { $axis ->
        [line] de ligne
       *[sample] de colonne
     } vaut { NUM($ratio, digits: 2) } de sa valeur au centre (limite { $limit }).

rpc-point_shape = Les points sont de forme ({ $shape }).

rpc-height_range = La plage d'altitudes est de { $low_m } à { $high_m } m.

rpc-no_fit = Aucun RPC sans zéro dans un dénominateur ne convient à ce modèle.

rpc-inaccurate_fit = Le meilleur RPC s'écarte de ce modèle de { $misfit_px } px (limite { $limit_px } px).

rpc-scene_localisation = Scène { $scene } : un point image n'a pas de point terrain.

rpc-corrected = RPC { $kind ->
        [none] non corrigé
        *[other] corrigé ({ $kind })
    } : résidus { NUM($x_px, digits: 2) }, { NUM($y_px, digits: 2) } px (EMQ, { $n } points d'appui).

rpc-check_points = { $n } points de contrôle : { NUM($rms_m, digits: 2) } m au sol ({ NUM($x_px, digits: 2) }, { NUM($y_px, digits: 2) } px EMQ).

rpc-ground_errors = Exactitude au sol (68 %, par axe) : ERR_BIAS { NUM($bias_m, digits: 2) } m, ERR_RAND { $rand_known ->
        [yes] { NUM($rand_m, digits: 2) } m
        *[no] inconnue
    }.

rpc-points_contradict = { $n } points d'appui sur { $of } contredisent les autres : { $names } (jusqu'à { NUM($largest_px, digits: 2) } px).

rpc-points_outside = { $n } points d'appui hors de l'image ou des hauteurs du RPC : { $names }.

rpc-shift_large = Le décalage vaut { NUM($ratio, digits: 2) } fois le biais annoncé par le fournisseur.

rpc-residuals_large = Les résidus valent { NUM($ratio, digits: 2) } fois le sigma annoncé de { $sigma_px } px.

rpc-no_redundancy = { $n } points d'appui ne laissent aucune redondance.

rpc-error_sources = 1 m d'erreur de hauteur déplace un point de { NUM($east, digits: 2) } m à l'est, { NUM($north, digits: 2) } m au nord.

rpc-refitted = RPC réajusté : au plus { NUM($largest_px, digits: 2) } px du RPC corrigé.

rpc-other_image = Le RPC n'appartient pas à cette image de { $width_px } x { $height_px } px.

rpc-projection_not_finite = RPC : sa projection n'est pas finie dans la scène.

rpc-keys_missing = Le RPC est incomplet ; il manque : { LIST($names, most: 10) }.

rpc-coefficient_count = Le RPC est incomplet : { $name } a { $n } de 20 coefficients.

rpc-metadata_below = Les métadonnées du domaine RPC sont dans un élément inférieur, pas dans la racine.

rpc-not_one = Le fichier contient { $n } RPC{ $n ->
     [0] { "" }
     *[other] { " " }({ $names })
    } ; il en faut exactement un.

rpc-two_values = Cette clé vaut ici { $value } et { $other } à la ligne { $other_line }.

rpc-unit = L'unité est { $unit } ; le RPC exige { $needed }.

rpc-no_tag = Le fichier TIFF ne contient pas de RPC (balise 50844).

rpc-tag_count = La balise RPC a { $n } nombres ; il en faut 92.

rpc-not_finite = RPC : un nombre n'est pas fini.

rpc-geotiff_needs_picture = Un GeoTIFF avec RPC exige l'image de la scène, qui manque.

rpc-file_precedes_tag = { $name } est dans le même dossier ; GDAL lirait son RPC au lieu de la balise.

rpc-name_ending = { $ending ->
     [blank] Le nom n'a pas d'extension
     *[other] L'extension { $ending } n'est d'aucun format de RPC
    }.

rpc-tag_differs = La balise écrite par GDAL diffère du RPC ; aucun fichier n'est écrit.

rpc-terms_reordered = Les termes du RPC00A ont été mis dans l'ordre de RPC00B.

rpc-specification_assumed = { $specification ->
     [none] La spécification du RPC manque
     *[other] La spécification du RPC est { $specification }
    } ; RPC00B est supposé.

rpc-point_far_away = Un point est à { NUM($ratio, digits: 4) } fois l'étendue des RPC du centre de la scène (limite { $limit }).

rpc-control_set_aside = Scène { $scene } : points en contradiction avec les autres, non utilisés : { $points }.

rpc-scene_left_out = La scène { $scene } n'est pas corrigée.

rpc-points_beyond = Points hors du domaine de validité du RPC : { $points }.

rpc-points_lost = Points sans coordonnées { $which ->
    [ground] terrain
    *[image] image
 } : { $points }.

rpc-bursts = Aucun RPC ne décrit une image de { $n } bursts : des lignes entre eux sont prises deux fois.
    .do = Utiliser la scène elle-même (model = "range_doppler"), ou obtenir le produit en distance au sol.
