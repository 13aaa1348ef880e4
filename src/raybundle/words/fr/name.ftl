name-unprintable = { $name } n'est pas un nom imprimable.

name-twice = { $kind ->
        [camera] Caméra
        [image] Image
        [point] Point
        [rig] Rig
       *[other] Nom
     } { $name } : figure deux fois.

name-missing = Le nom manque.

name-blanks = { $name } est vide ou a des espaces aux extrémités.
