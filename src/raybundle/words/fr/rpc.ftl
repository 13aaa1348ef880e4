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
