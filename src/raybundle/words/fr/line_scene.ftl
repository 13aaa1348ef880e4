line_scene-table_order = { $table ->
        [line_times] Temps de ligne
       *[viewing_directions] Directions de visée
     } : { $n } entrées, trop peu ou non croissantes.

line_scene-times_not_monotonic = Les temps de ligne ne sont pas monotones le long de l'image.

line_scene-ray_misses_body = Le rayon du point image { NUM($x_px, decimals: 2) }, { NUM($y_px, decimals: 2) } px manque le corps de { NUM($miss_m, decimals: 1) } m.

line_scene-point_not_seen = Le point { $point } n'est pas dans cette scène.

line_scene-smooth_unknown = smooth : { $name } n'est pas un axe d'une courbe.

line_scene-below_ground = L'altitude du terrain { $height_m } m est { NUM($above_m, decimals: 1) } m au-dessus du capteur.
