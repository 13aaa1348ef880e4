given_twice = { $kind ->
        [scale_bar] Règles
       *[length] Longueurs
     } données deux fois et comptées une fois : { LIST($ids, most: 10) }.
