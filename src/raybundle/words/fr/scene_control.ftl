scene_control-height_unit = Les altitudes d'appui semblent être en { $unit }, pas en mètres.

scene_control-image_axes = Les points d'appui tournent ou étirent l'image de { PERCENT($share) } % avec le biais { $model } (limite { PERCENT($limit) } %).

scene_control-other_images = Le fichier ne contient aucun point image de la scène { $scene }.

scene_control-geographic_columns = Les colonnes { $columns } sont en WGS 84 avec altitudes ellipsoïdales.

scene_control-image_points_twice = Le fichier a ses propres points image ; { $table } ne peut être ajouté.

scene_control-no_image_point = Les points d'appui n'ont pas de points image.

scene_control-no_point = Le fichier ne contient aucun point.

scene_control-point_twice = Le point { $point } apparaît deux fois.

scene_control-point_missing = Le point { $point } manque dans { $table }.

scene_control-attribute_not_a_number = Attribut { $name } : { $value } n'est pas un nombre.

scene_control-no_image_attributes = Le point n'a pas d'attributs x_px et y_px.

scene_control-not_a_point = La géométrie est { $kind }, pas Point.

scene_control-coordinate_count = Coordonnées du point : { $n } ; il en faut 2 ou 3.

scene_control-no_layer = Le fichier n'a pas de couche avec { $points ->
     [yes] des points
     *[no] les colonnes { LIST($columns, most: 6) }
    }.

scene_control-no_height = { $n } points sur { $total } n'ont pas d'altitude ; le premier est { $point }.

scene_control-other_system = Les points d'appui sont en { $own }, { OPTION("crs") } est { $system }.

scene_control-not_degrees = Le point { $point } ({ NUM($x, digits: 10) }, { NUM($y, digits: 10) }) n'est pas en degrés, sans système de coordonnées.

scene_control-not_points = La géométrie de cette ligne n'est pas un point.

scene_control-image_assumed = Les points image de { $name } sont de { $image } ; ils sont utilisés pour { $scene }.

scene_control-wgs84_assumed = Système de coordonnées des points d'appui : non défini ; WGS 84 avec altitudes ellipsoïdales supposé.

scene_control-columns_missing = Les colonnes { LIST($header, most: 12) } ne forment pas une table de points d'appui.

scene_control-check_only = Tous les points sont des points de contrôle.

scene_control-image_missing = Il y a { $n } scènes, mais des points ne nomment pas l'image où ils sont mesurés.
