repeated_structure = Structures répétées : { PERCENT($before) } % des appariements en contredisent d'autres (limite { PERCENT($limit) } %).

repeated_structure-ambiguous = Structures répétées : { PERCENT($after) } % des appariements en contredisent d'autres (limite { PERCENT($limit) } %).

repeated_structure-groups = Structures répétées : { $groups } groupes de photographies montrent peut-être des parties différentes qui se ressemblent.

repeated_structure-group = Groupe de { $n } photographie(s) : { LIST($names, most: 4) }

repeated_structure-missing = Structures répétées : deux groupes de photographies montrent peut-être des parties différentes qui se ressemblent.

repeated_structure-rearranged = Structures répétées : deux groupes de photographies de parties semblables ont été replacés.

repeated_structure-unsettled = Structures répétées : { $pairs } paires de photographies s'apparient bien et contredisent l'orientation.
