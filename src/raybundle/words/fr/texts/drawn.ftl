drawn-object = l’objet { $side ->
        [above] vu d’en haut
        *[square] vu perpendiculairement à son plan moyen
    }, { $n } { $n ->
        [one] point
        *[other] points
    } en couleur selon l’écart-type

drawn-object_colours = Couleur : écart-type d’une coordonnée, moyenne quadratique { $plan ->
        [yes] en plan
        *[no] de X, Y et Z
    }{ $median ->
        [yes] {" "}; médiane des points voisins
        *[no] {""}
    }.

drawn-object_points = L’objet { $side ->
        [above] vu d’en haut
        *[square] vu perpendiculairement à son plan moyen
    } : { $n } { $n ->
        [one] point
        *[other] points
    }.

drawn-object_stations = Petits triangles : photographies{ $outside ->
        [0] {""}
        *[other] {" "}({ $outside } à l’extérieur)
    }.

drawn-photograph_points = Photographie { $name } avec ses { $n } points, dans les mêmes couleurs.
