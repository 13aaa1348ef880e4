control_contradicts-scattered = Les points d'appui de { $name } ne concordent pas : seulement { $agree } sur { $n }.

control_contradicts-scale = Les appuis de { $name } et les règles diffèrent en échelle de { $near_1 ->
        [yes] { NUM($scale_ppm, digits: 4) } ppm
       *[no] un facteur de { NUM($factor, digits: 6) }
     }.

control_contradicts-ambiguous = { $n } points d'appui de { $name } contredisent les autres ; lesquels sont faux est ambigu.

control_contradicts-rejected = { $points } points d'appui sur { $control } ont plus de { PERCENT($limit) } % de leurs points image rejetés : { $ids }.
