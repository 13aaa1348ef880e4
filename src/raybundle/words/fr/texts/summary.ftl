summary-adjusted = Compensation : { $images } images, { $points } points objet, { $observations } observations d'image{ $rejected ->
        [0] {""}
        *[other] , dont { $rejected } rejetées
    }.

summary-accuracy_of_check_points = Exactitude sur { $n } points de contrôle : { NUM($rms, digits: 2) } { $unit } (EMQ d'une coordonnée).

summary-precision = Écart-type des points objet : { $few ->
        [yes] { NUM($median, digits: 2) } { $unit } (médiane d'une coordonnée ; EMQ { NUM($rms, digits: 2) })
        *[no] { NUM($rms, digits: 2) } { $unit } (EMQ d'une coordonnée)
    }{ $free_scale ->
        [yes] , échelle arbitraire
        *[no] {""}
    }.

summary-no_statistics = Pas d'écarts-types : les statistiques sont désactivées.

summary-no_object_points = Aucun point objet n'est estimé.

summary-counts = Utilisés : { $images } images sur { $images_given }, { $points } points sur { $points_given }, { $observations } observations sur { $observations_given }.

summary-sigma0 = { $known ->
        [yes] sigma0 = { NUM($sigma0, digits: 4) }
        *[no] sigma0 n'est pas estimable
    }, a priori { NUM($sigma_px, digits: 2) } px, redondance { $redundancy }.

summary-datum = Datum : { $datum }.

summary-precision_of_axes = Écart-type des points objet (EMQ) : X { $x }, Y { $y }, Z { $z } { $unit }.

summary-few_points = { $n } points sur { $of } portent { PERCENT($share) } % de la variance ; médiane X { $x }, Y { $y }, Z { $z } { $unit }.

summary-relative_precision = Précision relative 1 : { $n } (écart-type moyen { $std } { $std_unit }, plus grande étendue { $extent } { $extent_unit }).

summary-noise_white = Bruit blanc supposé : { $cause }.

summary-noise_neighbours = Les écarts-types contiennent des erreurs communes aux points voisins (variance multipliée par { NUM($factor, digits: 2) }).

summary-noise_smooth = Les écarts-types contiennent des erreurs régulières de { NUM($sigma_px, digits: 2) } px, propres à chaque image.

summary-noise_focus = Les écarts-types contiennent une mise au point qui varie de { NUM($sigma_px, digits: 2) } px.

summary-noise_factor = Écarts-types { $kind ->
        [interior] de l'orientation interne
        [centres] des centres de projection
        *[points] des points objet
    } : { NUM($factor, digits: 2) } fois ceux du bruit blanc (médiane).

summary-relief = Le relief des fenêtres double au moins l'écart-type de { PERCENT($share) } % des points de liaison.

summary-check_points = Points de contrôle ({ $n }) : EMQ des écarts en { $axes } : { $rms } { $unit }.

summary-more = et { $n } autres : avec { OPTION("verbose", "True") }.

summary-next = Étape suivante : { $step }

summary-files = Écrit : { $files }.

summary-next_surface = raybundle surface { $project } calcule la surface.

summary-next_scale = Donner une base d'échelle ({ OPTION("scale_bar", "A", "B", "LONGUEUR", "SIGMA") }) ou des points d'appui.

summary-oriented = Orientées : { $oriented } photographies sur { $of }, { $points } points objet{ $lost ->
        [0] {""}
        *[other] ; non orientées : { LIST($names, most: 2) }
    }.

summary-image_points = Écart-type d'une coordonnée image : { NUM($sigma_px, decimals: 3) } px (résidus).

summary-scenes = Scènes satellite dans le bloc : { $oriented } sur { $of }.

summary-part = { $n } photographies forment une partie séparée : { $folder }.

summary-try_xfeat = { OPTION("features", "xfeat") } apparie des photographies à bases plus larges (pip install 'raybundle[learned]').

summary-marks_left_out = { $n } points avec moins de deux marques ne sont pas utilisés : { $names }.
