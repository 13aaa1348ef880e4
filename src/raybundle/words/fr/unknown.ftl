unknown-image = Image { $image } : { $part ->
        [rotation_x] la rotation autour de x
        [rotation_y] la rotation autour de y
        [rotation_z] la rotation autour de z
        *[other] la coordonnée { $part } du centre de projection
    } n'est pas déterminée.

unknown-parameter = Le paramètre { $symbol } de la caméra { $camera } n'est pas déterminé.

unknown-point = Point { $point } : la coordonnée { $axis } n'est pas déterminée.

unknown-other = L'inconnue { $number } n'est pas déterminée.
