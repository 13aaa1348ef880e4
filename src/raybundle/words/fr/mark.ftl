mark-exists = Le point { $point } est déjà marqué dans l'image { $image }.

mark-name_taken = Le point { $point } ne peut pas être renommé { $to } : ce nom est pris.

mark-point_of_block = Le point { $point } vient du bloc ; aucune marque n'est mesurée à la main.

mark-bar_same_ends = Barre d'échelle { $start } - { $end } : les deux extrémités sont le même point.

mark-bar_sigma = Barre d'échelle { $start } - { $end } : l'écart-type { $sigma } est trop grand pour une longueur de { $length }.

mark-no_bar = Il n'y a pas de barre d'échelle { $start } - { $end }.

mark-no_line = Il n'y a pas de ligne { $line_name }.

mark-line_points = La ligne { $line_name } (type { $kind }) a { $n } points différents ; il en faut { $least }.

mark-no_observation = Le bloc n'a pas d'observation du point { $point } dans l'image { $image }.

mark-not_rejected = Le point { $point } dans l'image { $image } n'est pas rejeté à la main.

mark-bad_name = { $kind ->
        [line] La ligne
        [drawing] Le dessin
        [layer] Le calque
        [note] La note
        [mask] Le masque
        [table] La table
       *[point] Le point
     } { $name } a un nom non valable ({ $n } caractères).

mark-sigma_without_coordinate = Le point { $point } a un écart-type de { $axis }, mais pas de { $axis }.

mark-role_without_coordinate = Le point { $point } est un { $role ->
        [check] point de contrôle
       *[control] point d'appui
     } sans coordonnées.

mark-control_without_sigma = Point d'appui { $point } : { $axis } n'a pas d'écart-type.

mark-unknown_point = Le point { $point } n'est ni mesuré ni dans le bloc.

mark-not_marked = Le point { $point } n'est pas marqué à la main dans l'image { $image }.

mark-covariance = Image { $image } : une covariance de { $xy_px2 } px² est impossible avec des variances de { $xx_px2 } et { $yy_px2 } px².

mark-unknown_image = L'image { $image } n'est pas l'une des { $n } images.

mark-outside_image = Image { $image } : x = { NUM($x_px, digits: 6) }, y = { NUM($y_px, digits: 6) } est hors de ses { $width_px } x { $height_px } px.

mark-mask_corners = Le masque { $mask } a { $n } sommets ; 3 à { $most } sont possibles.

mark-mask_area = Masque { $mask } : ses sommets entourent { NUM($area_px2, digits: 2) } px², moins de { $least_px2 } px².

mark-no_mask = Il n'y a pas de masque { $mask }.

mark-drawing_corners = { $drawing } a { $n } sommets ; { $least } à { $most } sont possibles.

mark-drawing_surface = { $drawing } : { $surface } n'est pas un dossier du projet.

mark-no_drawing = Il n'y a pas de dessin { $drawing }.

mark-no_masks_at_all = Aucun masque n'est dessiné ni lu d'un dossier.

mark-image_not_in_block = Le point { $point } est marqué dans l'image { $image }, absente du bloc.

mark-control_far_away = Le point d'appui { $point } est à { $distance } { $unit } des autres, { $ratio } fois leur étendue.

mark-outside_photograph = { NUM($x_px, digits: 6) }, { NUM($y_px, digits: 6) } est hors de la photographie { $image } ({ $width_px } x { $height_px } px).

mark-not_in_result = Le point { $point } est marqué à la main, mais n'est pas dans ce résultat.

mark-nothing_to_reject = Ni point d'image ni limite unique ne sont donnés.

mark-contradicts = { $n ->
        [one] La marque de { $point } dans { $images } contredit les autres
       *[other] Les marques de { $point } se contredisent : { $images }
    }.

mark-off = La marque de { $point } dans { $image } est à { NUM($distance_px, digits: 2) } px ({ NUM($sigmas, digits: 2) } écarts-types) des autres.

mark-fits = { $point } convient : { NUM($distance_px, digits: 2) } px ({ NUM($sigmas, digits: 2) } écarts-types) des autres.

mark-open = { $point } n'est pas encore contrôlé : { NUM($distance_px, digits: 2) } px des autres, de plus grandes erreurs sont possibles.

mark-tested_later = La marque de { $point } dans { $image } n'est pas encore contrôlée.

mark-control_names = { $n } points d'appui ne correspondent pas à leurs marques : après un décalage commun, l'écart est de { NUM($missed, digits: 2) } { $unit }.

mark-control_named = Les coordonnées de { $point } sont celles des marques de { $at }.

mark-control_apart = Le point d'appui le plus proche, { $point }, est à { NUM($distance, digits: 3) } { $unit } des photographies.

mark-control_unmarked = { $n } points d'appui sur { $of } ne sont marqués dans aucune photographie : { LIST($points, most: 8) }.
