names_exchanged = { $pairs } paire(s) de points image rejetés concordent avec les noms échangés : { $ids }.

names_exchanged-pair = { $first } et { $second } dans l'image { $image }
