depth_map-density = La densité d'une carte de profondeur est { $density } ; 1, 2 et 4 sont possibles.

depth_map-no_source = Image { $image } : aucune autre photographie ne convient à l'appariement dense avec elle.

depth_map-outside_region = L'image { $image } ne montre pas la région.

depth_map-too_few_points = L'image { $image } a { $n } points de liaison ; la plage de profondeurs en exige { $least }.

depth_map-source_count = L'image de référence a { $n } images sources ; de 1 à { $most } sont possibles.

depth_map-array_shape = Le tableau { $array } a la forme ({ $shape }).

depth_map-grid_outside = La grille de pixels s'étend jusqu'à { $x_px }, { $y_px } ; l'image a { $width_px } x { $height_px } px.

depth_map-memory = Des profondeurs de { $width_px } x { $height_px } px exigent plus de { NUM($memory_gb, digits: 2) } Go de mémoire.

depth_map-single_photograph = Une surface exige au moins deux photographies de la même partie de l'objet.

depth_map-depth_range = Des paramètres de profondeur de { $low } à { $high } ne sont pas une plage de profondeurs.

depth_map-projection_table = Image { $image } : la table de sa projection a des erreurs de { $error_px } px (limite { $limit_px } px).
