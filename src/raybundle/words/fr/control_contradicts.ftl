control_contradicts-scattered = Les points d'appui de { $name } ne concordent pas : seulement { $agree } sur { $n }.

control_contradicts-scale = Les appuis de { $name } et les règles diffèrent en échelle de { $near_1 ->
        [yes] { NUM($scale_ppm, digits: 4) } ppm
       *[no] un facteur de { NUM($factor, digits: 6) }
     }.

control_contradicts-ambiguous = { $n } points d'appui de { $name } contredisent les autres ; lesquels sont faux est ambigu.

control_contradicts-rejected = { $points } points d'appui sur { $control } ont plus de { PERCENT($limit) } % de leurs points image rejetés : { $ids }.

control_contradicts-mirrored = Les points d'appui sont une image miroir de l'objet : sigma0 vaut { $mended } une fois inversés (limite { $limit }).

control_contradicts-mend = { $mend ->
     [xy] X et Y des points d'appui sont intervertis
     [yz] Y et Z des points d'appui sont intervertis
     [xz] X et Z des points d'appui sont intervertis
     [x] X des points d'appui a le mauvais signe
     [y] Y des points d'appui a le mauvais signe
     *[z] Z des points d'appui a le mauvais signe
    }

control_contradicts-exchanged = Les points d'appui { $names } semblent intervertis : une fois échangés, sigma0 vaut { $mended } (limite { $limit }).

control_contradicts-points = { $n ->
     [one] Le point d'appui { $names } contredit
     *[other] Les points d'appui { $names } contredisent
    } les photographies et les autres points d'appui.

control_contradicts-centres = Les points d'appui et les centres de projection observés se contredisent.

control_contradicts-axis = { $axis } : centres moins points d'appui { $apart } (± { NUM($sigma, digits: 2) })

control_contradicts-one_of_few = Un des points d'appui { $names } est faux ; lequel est ambigu.

control_contradicts-unexplained = Les { $n } points d'appui ne s'accordent pas aux photographies ; aucun point seul ne l'explique.
