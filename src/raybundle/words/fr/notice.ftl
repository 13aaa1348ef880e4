notice-also = Il en va de même pour { $n } { $n ->
        [one] autre objet
        *[other] autres objets
    } : { LIST($names, most: 10) }.
