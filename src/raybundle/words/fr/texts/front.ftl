front-title = En bref

front-verdict = Verdict

front-client = Client

front-operator = Opérateur

front-object = Objet

front-place = Lieu

front-date = Date

front-instruments = Instruments

front-rights = Droits

front-heights = Altitudes

front-coordinate_system = Système de coordonnées

front-asprs_statement = Énoncé ASPRS{ $height ->
        [yes] , altitude
        *[no] {""}
    }

front-calibration = Étalonnage

front-adjustment = Compensation de { $name }

front-faults = Ne pas utiliser encore : { $n } { $n ->
        [one] défaut
        *[other] défauts
    } à régler.

front-no_statistics = Non vérifié : statistiques désactivées, précision inconnue.

front-no_redundancy = Non vérifié : aucune observation surabondante.

front-contradicting = Ne pas utiliser encore : les observations se contredisent.

front-calibration_unusable = Ne pas utiliser pour d'autres photographies : l'étalonnage est { $grade ->
        [not_determinable] indéterminable
        *[weak] faible
    }.

front-not_as_required = Moins exact qu'exigé.

front-usable = Utilisable{ $n ->
        [0] {""}
        [one] , { $n } avertissement
        *[other] , { $n } avertissements
    }.

front-not_judged = Les exigences ne peuvent pas être évaluées.

front-not_checked = Pas de contrôle indépendant (aucun point de contrôle).

front-severity = { $level ->
        [error] erreur
        [fault] défaut
        [warning] avertissement
        [next] ensuite
        *[note] note
    }

front-next = Prochaines étapes

front-more_matters = { $n } de plus : voir les avertissements.

front-handed_over = Livrables

front-files = Fichiers : { LIST($names, most: 15) }.

front-settled = Aucun point ouvert.

front-not_kept_only = Exigences non respectées (voir ci-dessus) ; la mesure n'a pas de point ouvert.

front-file_name = { $name } :

front-file = { $file_name ->
        [points] coordonnées des points objet avec écarts-types.
        [map] points objet et stations dans le système de coordonnées.
        [map_control] points d'appui et de contrôle dans le système de coordonnées.
        [coordinate_list] coordonnées des cibles avec écarts-types et corrélations.
        [nominal] écarts aux coordonnées nominales.
        [lengths] erreurs de longueurs connues.
        [images] orientations des photographies.
        [calibration] caméras étalonnées.
        [record] fiche de prise de vue.
        [check] points de contrôle.
        [control] points d'appui.
        [block] le bloc complet, pour une nouvelle compensation.
        [displacements] déplacements avec écarts-types et verdict.
        [velocities] vitesses et accélérations.
        [surface_strain] déformations de la surface.
        [epochs] dates, points et zones déplacés, pour les programmes.
        *[network] réseau en trois dimensions.
    }

front-dense_points = Nuage de points d'un résultat antérieur : { $file_name }.

front-system_of_control = Celui des points d'appui (sans nom).

front-heights_relative = Relatives : aucune altitude donnée.

front-heights_of_geoid_value = { $name }, ondulation du géoïde { NUM($undulation_m, digits: 6) } m.

front-heights_of_grid = { $name }, modèle de géoïde { $grid }.

front-heights_above_geoid = Au-dessus du géoïde, ondulation { NUM($undulation_m, digits: 6) } m.

front-heights_ellipsoidal = Au-dessus de l'ellipsoïde.

front-heights_assumed = Non définies par le système de coordonnées ; altitudes ellipsoïdales supposées.

front-of_given = sur { $n }

front-rays = chacun sur { NUM($n) } photographies (médiane)

front-uncertainty = Médiane sur le format à l'infini ; maximum { NUM($largest_px, digits: 2) } px.

front-worst_camera = Caméra { $camera }, la moins bonne de { $n }.

front-good_to = convient aux mesures jusqu'à

front-largest_error = erreur maximale sur le format (probabilité 95 %)

front-coverage = couvert par les points image de toutes les photographies

front-median_uncertainty = incertitude, médiane

front-largest_uncertainty = maximum

front-uncertainty_meaning = Incertitude d'un point image due au seul étalonnage, sur le format, à l'infini.

front-gsd = résolution au sol (GSD)

front-gsd_range = médiane sur les points objet ; 98 % entre { NUM($low) } et { NUM($high) } { $unit }

front-flying_height = hauteur de vol

front-above_ground = au-dessus du sol, médiane sur les photographies

front-area = surface

front-area_of_one = sur trois photographies ou plus, dans l'étendue des points objet ; sur une ou plus : { NUM($area) } { $unit }

front-std_of_coordinate = D'une coordonnée, { $median ->
        [yes] médiane
        *[no] EMQ
    } sur les points objet :

front-quotient = Écart-type moyen { NUM($mean) } { $unit }, étendue { NUM($extent) } { $length_unit }{ $share ->
        [0] {""}
        *[other] , sans les { PERCENT($share) } % de points les moins précis
    }.

front-check_rms = Écart (EMQ) d'une coordonnée sur { $n } { $n ->
        [one] point
        *[other] points
    } de contrôle :

front-leave_one_out = validation croisée des points d'appui

front-leave_one_out_rms = Écart (EMQ) d'une coordonnée sur { $n } { $n ->
        [one] point
        *[other] points
    } d'appui, chacun exclu :

front-minus_given = d : compensé moins donné. Les points d'appui ont participé, pas les points de contrôle.

front-largest_differences = Les { $most } plus grands écarts de { $n } points { $role ->
        [control] d'appui
        *[check] de contrôle
    } ; tous : { $file_name }.

front-leave_one_out_row = validation croisée des points d'appui, EMQ

front-leave_one_out_meaning = Validation croisée : écart sans le point d'appui, au premier ordre.

front-dash = – : { $cause ->
        [lost] non donné
        [open] non comparé, laissé libre par le datum
        *[both] non donné, ou laissé libre par le datum
    }.

front-role = { $role ->
        [control] appui
        *[check] contrôle
    }

front-rms_of = EMQ de { $n }

front-held = fixe

front-rms = EMQ

front-median = médiane

front-quantile_95 = 95 % sous

front-largest = maximum

front-standard_deviations = Écarts-types des points objet. { $lengths ->
        [yes] Longueurs indépendantes : voir ci-dessus.
        *[no] Ni appui ni contrôle : pas de contrôle indépendant.
    }

front-weakest_point = Maximum : point { $point }, sur { $n } { $n ->
        [one] photographie
        *[other] photographies
    }.

front-known_lengths = Ces longueurs ont participé. Validation croisée : longueur d'après les autres moins donnée, au premier ordre.

front-more_lengths = { $n } de plus : distances.csv.
