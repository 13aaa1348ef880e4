names_exchanged = { $pairs } paire(s) de points image rejetés concordent avec les noms échangés : { $ids }.

names_exchanged-pair = Les noms { $first } et { $second } semblent échangés dans l'image { $image }.
