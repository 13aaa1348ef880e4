panels-no_coordinates = Le point { $point } n'a pas de coordonnées données.

panels-no_control = Aucun point d'appui ou de contrôle n'a de coordonnées données.

panels-not_placed = Rien ne place le bloc dans le système de coordonnées des points d'appui.

panels-found = Cibles au sol trouvées : { $n } points sur { $of }, { $marks } nouvelles mesures.

panels-shift = Bloc moins coordonnées données : X { NUM($x, digits: 3) }, Y { NUM($y, digits: 3) }, Z { NUM($z, digits: 3) } { $unit } (médiane) ; dispersion des points { NUM($spread, digits: 2) } { $unit }.

panels-missed = Points sans cible : { LIST($names, most: 6) }. { $why ->
        [not_visible] Aucune photographie ne montre leur place.
        [nothing] Rien ne se distingue près de leur place.
        [few_rays] Moins de { $least } photographies montrent une cible.
        [few_points] Moins de { $least } points montrent une cible.
        [ambiguous] Plusieurs cibles conviennent.
        [off] La cible la plus proche contredit les autres points.
        *[no_panel] La place ne peut être mesurée comme croix, damier ou disque.
    }

panels-off = { $point } : { NUM($distance, digits: 3) } { $unit } de sa place.

panels-files_not_read = Les fichiers de points d'appui du projet n'ont pas été lus.

panels-photographs_lost = Photographies absentes ou illisibles : { $n } ({ LIST($names, most: 6) }).
