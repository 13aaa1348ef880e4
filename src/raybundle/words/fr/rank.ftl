rank-not_determined = Les observations ne déterminent pas toutes les inconnues.

rank-no_observation = { $n } inconnue(s) sans observation.

rank-parallel_rays = Les rayons vers { $n } point(s) objet sont parallèles ou confondus : { LIST($points, most: 10) }.

rank-undetermined_together = Indéterminés ensemble :

rank-share = { $kind ->
        [parameter] { $symbol } de la caméra { $name } { $image }
        [image] Orientation externe de l'image { $name }
        [point] Point { $name }
       *[other] { $name }
     } ({ PERCENT($share) } %)
