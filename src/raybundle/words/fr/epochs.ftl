epochs-datum_points_missing = Des points de référence manquent dans certaines époques : { $names }.

epochs-only_one = Un test de congruence demande au moins deux époques.

epochs-too_few_common = { $epochs } : { $n } points ont des noms communs ; il en faut { $least }.

epochs-no_sigmas = { $first } et { $second } n'ont pas d'écarts-types.

epochs-covariance_singular = La matrice de covariance des époques est singulière au-delà de la référence.

epochs-mirrored = Les points de { $first } et { $second } sont des images miroir.

epochs-scattered = Les points de { $first } et { $second } ne concordent pas : seulement { $agree } sur { $n }.

epochs-other_unit = Les distances dans { $first } valent { NUM($factor, digits: 6) } fois celles de { $second }.

epochs-points_in_line = Les { $n } points communs sont alignés ou confondus dans { $epoch }.

epochs-same_observations = { $first } et { $second } sont la même mesure.

epochs-faulty = { $name } a lui-même { $n } fautes.

epochs-stable_points_differ = Les points stables diffèrent de plus que leurs écarts-types ({ P($p) }).

epochs-stable_ambiguous = Deux ensembles de points stables conviennent aussi bien : { $stable } et { $other } de { $points } points.

epochs-free_scale = L'échelle de { $names } n'est pas fixée : une dilatation de tous les points n'est pas détectée ({ $scale_ppm } ppm).

epochs-points_unknown = Aucune mesure ne contient { LIST($points, most: 10) }.

epochs-joint_order = La covariance commune de { $epochs } exige les mêmes points dans le même ordre.

epochs-group_empty = Aucun point du groupe { $name } n’a de position à chaque date.

epochs-group_without = Le groupe { $name } est testé sans { LIST($names, most: 5) }.

epochs-group_text = { $text } n’est pas un groupe.

epochs-dates_not_joined = { $date } a { $common } points en commun avec d'autres dates, toutes les dates { $n } (il en faut { $least } ; photos : { $photographs }).

epochs-one_date = Les déplacements exigent des images d’au moins deux dates ; il y a { LIST($dates, most: 1) }.

epochs-no_date_text = { $text } n’est pas une date.

epochs-photographs_without_date = Photos sans date ({ $n }) : { LIST($names, most: 5) }.

epochs-dates_contradict = EXIF contredit { $start } et { $end } : les photographies datent du { $first } et du { $last }.

epochs-date_of_many_days = Les photographies du { $date } ont été prises du { $first } au { $last } (EXIF).

epochs-dates_not_paired = Dossiers ajoutés : { $add } ; dates : { $dates }.

epochs-no_photographs = { $project } n’a pas de photos.

epochs-photographs_left_out = { $date } : photos sans emploi, { $n } sur { $total } : { LIST($names, most: 3) }{ $copies ->
        [0] {""}
       *[other] ; copies : { $copies }
    }{ $unusable ->
        [0] {""}
       *[other] ; inutilisables : { $unusable }
    }{ $lost ->
        [0] {""}
       *[other] ; non orientées : { $lost }
    }.

epochs-source_empty = { $folder } n’a pas de photos propres.

epochs-limit = { $text } n’est pas une longueur.

epochs-limit_not_tested = { $limit } n’est pas testé : les longueurs n’ont pas d’échelle.

epochs-no_scale = Les longueurs n’ont ni échelle ni unité.

epochs-camera_changed = La caméra { $camera } a une autre orientation interne à chaque date (F { NUM($F) }, { P($p) }).

epochs-limit_exceeded = Déplacements de plus de { $limit } : { $n } ; { $name } { NUM($length_mm, digits: 3) } mm jusqu’au { $end } (probabilité supérieure à { PERCENT($confidence) } %).

epochs-limit_kept = La limite { $limit } est contrôlée sur { $tested } points de { $points } ; aucun déplacement ne la dépasse là ({ PERCENT($confidence) } %).

epochs-limit_below_detection = { $limit } n'est pas contrôlé pour { $n } points sur { $points } : sous le seuil de détection.

epochs-no_animation = L'animation des dates n'a pas été écrite.
