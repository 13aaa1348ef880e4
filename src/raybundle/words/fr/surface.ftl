surface-points = Surface : { $n } points de { $maps } cartes de profondeur.

surface-precision = Écart-type d'un point : { NUM($median, digits: 2) } { $free_scale ->
        [yes] unités (médiane, échelle arbitraire)
        *[no] { $unit } (médiane)
    }.

surface-precision_of_axes = Écart-type médian : X { $x }, Y { $y }, Z { $z }, le long du rayon { $along_ray } { $unit }.

surface-shares = Variance le long du rayon : bruit { $noise } %, rugosité { $roughness } %, orientation { $orientation } %.

surface-plane_without_heights = { OPTION($setting) } concerne une grille d'altitudes ; aucune n'est demandée.

surface-foreign_file = Le dossier contient { $name }, qui n'appartient pas à une surface.

surface-no_point_above_area = Aucun point de la surface n'est au-dessus de la zone des altitudes.

surface-scale_free = L'échelle du bloc n'est pas déterminée ; une surface n'a pas d'unité de longueur.

surface-mesh_empty = Aucun triangle de côté { $side } n'a d'altitudes à tous ses sommets.

surface-region_too_small = La région de { $width } x { $height } est plus petite que l'espacement des points de { $apart }.

surface-region_not_readable = { OPTION("region", $given) } n'est ni un fichier ni au moins trois sommets.

surface-too_many_cubes = { OPTION("thin", $side) } divise la surface en plus de { $most } cubes.

surface-orthophoto_not_shown = Aucune photographie ne montre la zone de l'orthophoto.

surface-region_not_shown = Aucune photographie qui mesure des profondeurs ne montre la région.

surface-no_pair = Aucune paire de photographies ne peut mesurer des profondeurs.

surface-too_few_photographs = { $n } photographies du résultat sont disponibles ; une surface en demande { $least }.

surface-photographs_lost = { $n } photographies compensées sur { $photographs } ne sont pas utilisables.

surface-nothing_measured = Rien n'a été mesuré : { PERCENT($share) } % de { $pixels } pixels ont une profondeur, aucune confirmée.

surface-region_invalid = { OPTION("region", $given) } n'est pas une région valable.

surface-no_depth_map = Aucune carte de profondeur n'a pu être calculée.

surface-other_photographs = Rien n'a été mesuré : des photographies diffèrent de celles qui ont été orientées.

surface-photographs_replaced = { $n } photographies ne sont pas les fichiers qui ont été orientés : { $names }.

surface-photographs_exchanged = { $n } photographies contiennent l'image d'une autre (fichier : image) : { $names }.
