strain-displacements = { $name } : { $n } imagettes suivies sur { $of }, écart-type { NUM($sigma_px, digits: 2) } px.

strain-motion = Mouvement commun { NUM($u_px, digits: 4) } px à droite, { NUM($v_px, digits: 4) } px vers le bas, { NUM($rotation_deg, digits: 3) } deg.

strain-strains = Déformation médiane [1e-6] : xx { NUM($xx, digits: 3) }, yy { NUM($yy, digits: 3) }, xy { NUM($xy, digits: 3) }, chacune ± { NUM($sigma, digits: 2) } ; 99 % sous { NUM($largest, digits: 3) }.

strain-not_followed = { $name }{ $images ->
        [one] {""}
        *[other] , la pire de { $images } images
    } : { $n } imagettes sur { $of } non suivies ({ LIST($states, most: 7) }).

strain-bent = { $name } : { PERCENT($share) } % des imagettes se déforment plus qu'une affinité ({ $limit_px } px).

strain-no_strain = { LIST($names, most: 3) } : pas de déformation, trop peu d'imagettes suivies et reliées ({ $gauge } x { $gauge }).

strain-no_subset = Aucune imagette de { $window } x { $window } pixels ne tient dans l'éprouvette.

strain-nothing_followed = Aucune des { $n } imagettes n'est retrouvée dans { LIST($names, most: 3) }.

strain-other_size = { $width_px } x { $height_px } pixels, mais { $reference } en a { $reference_width_px } x { $reference_height_px }.

strain-same_image = L'image est une copie de la référence { $reference }.

strain-empty_extent = L'emprise { LIST($extent) } ne contient aucun pixel.

strain-map_empty = aucune valeur

strain-repeated = { $name } : la texture se répète après { NUM($period_px, digits: 3) } px (corrélation { NUM($correlation, digits: 2) }).

strain-saturated = { $name } : { PERCENT($share) } % des pixels ont la valeur de gris extrême (limite { PERCENT($limit) } %).

strain-mask_empty = Le masque { $name } ne masque rien.

strain-pages = Seule la première image est utilisée des fichiers qui en ont plusieurs : { LIST($names, most: 3) }.

strain-jumps = { $name } : { $n } de { $of } fenêtres voisines se contredisent : les déplacements sautent.

strain-same_content = La référence elle-même, déplacée ou non : { LIST($names, most: 3) }.

strain-image_twice = L'image est donnée deux fois.

strain-area = Zone { $name } ({ $n } subsets), déformation [1e-6] : xx { NUM($xx, digits: 3) } ± { NUM($s_xx, digits: 2) }, yy { NUM($yy, digits: 3) } ± { NUM($s_yy, digits: 2) }, xy { NUM($xy, digits: 3) } ± { NUM($s_xy, digits: 2) }.

strain-area_text = { $text } n'est pas une zone.

strain-area_not_one = Zone { $name } ({ $n } subsets) sans déformation unique ; plan [1e-6] : xx { NUM($xx, digits: 2) }, yy { NUM($yy, digits: 2) }, xy { NUM($xy, digits: 2) }.

strain-area_uneven = La déformation n'est pas uniforme dans { $n } zones, surtout dans { $area } ({ $name }).

strain-area_empty = La zone { $area } a trop peu de subsets dans { LIST($names, most: 3) }.

strain-area_outside = La zone { $area } n'est pas dans l'image de { $width_px } x { $height_px } px.
