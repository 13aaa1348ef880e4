surface_files-correlation = { $correlation } n'est pas une corrélation entre 0 et 1.

surface_files-unit_unknown = L'unité { $unit } des altitudes est inconnue.

surface_files-size_differs = La grille a { $columns } x { $rows } cellules ; { $about } en a { $needed_columns } x { $needed_rows }.

surface_files-place_differs = La grille et { $about } diffèrent ({ $quantity }) : { NUM($value, digits: 12) } et { NUM($needed, digits: 12) }.

surface_files-rotated = Les lignes de la grille sont tournées par rapport aux axes ; { $about } n'a pas de rotation.

surface_files-system_differs = La grille est en { $system } ; { $about } a { $needed }.

surface_files-other_surface = Le fichier appartient à une autre surface que { $about } : sa somme de contrôle diffère.

surface_files-infinite_heights = { $n } { $n ->
        [one] cellule a
       *[other] cellules ont
    } une altitude infinie.

surface_files-impossible_sigmas = { $n } des { $cells } cellules avec altitude ont un écart-type impossible ({ $band }).

surface_files-block_size = L'orientation des altitudes a des blocs de { $cells } cellules.

surface_files-node_count = Le fichier a { $nodes } nœuds ; des altitudes de { $rows } lignes et { $columns } colonnes en ont { $needed }.

surface_files-not_finite = Le fichier contient une valeur qui n'est pas un nombre fini.

surface_files-other_holes = Les trous remplis du fichier appartiennent à une autre surface.

surface_files-no_heights = Le dossier n'a pas de { $name } ; aucune grille d'altitudes n'a été écrite.

surface_files-node_dimensions = Les nœuds ont { $dimensions } dimensions ; il en faut 3 ou 4.

surface_files-bands_differ = { $sigmas } a { $n } bandes ; { $heights } en demande { $needed }.

surface_files-units_differ = Les unités diffèrent entre cette surface et { $other }.

surface_files-cells_differ = La surface a des cellules de { $cell }, { $other } de { $other_cell }.

surface_files-entry_missing = Le fichier n'a pas d'entrée { $name }.

surface_files-damaged = Le fichier est endommagé.

surface_files-vertical_datums_differ = Les références d'altitude diffèrent : { $system } et { $other_system }.

surface_files-one_in_map = L'une des surfaces est dans une carte, l'autre sur un plan de l'objet ({ $other }).

surface_files-systems_differ = Les surfaces sont dans des systèmes de coordonnées différents : { $system } et { $other }.

surface_files-plane_unknown = Le plan de cette surface ou de { $other } n'est pas connu.

surface_files-planes_differ = Les plans de cette surface et de { $other } diffèrent de { $off_cells } cellules (limite { $limit_cells }).
