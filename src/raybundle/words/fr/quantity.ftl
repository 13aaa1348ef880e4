quantity-coincide = Les points coïncident.

quantity-in_line = Les points sont alignés.

quantity-not_defined = La grandeur { $quantity } n'est pas définie par les points { $names }.

quantity-point_count = { $quantity } : { $n } points sont donnés ; { $most ->
        [0] il en faut au moins { $least }
       *[other] { $least } à { $most } sont possibles
     }.

quantity-none = Aucune grandeur n'est demandée.
