repeated_structure = Structures répétées : { PERCENT($before) } % des appariements en contredisent d'autres (limite { PERCENT($limit) } %).

repeated_structure-ambiguous = Structures répétées : { PERCENT($after) } % des appariements en contredisent d'autres (limite { PERCENT($limit) } %).

repeated_structure-groups = Structures répétées : { $groups } groupes de photographies montrent peut-être des parties différentes qui se ressemblent.

repeated_structure-group = Groupe de { $n } photographie(s) : { LIST($names, most: 4) }
