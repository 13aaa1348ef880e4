outline-crosses_itself = { $name } se croise aux côtés partant des sommets { $first } et { $second }.

outline-no_area = { $name } n'enferme aucune surface.

outline-not_one = Le fichier a { $n } lignes et surfaces ; il en faut une seule.

outline-no_pair = { $text } n'est pas une paire de nombres.

outline-empty = Le fichier ne contient pas de coordonnées.

outline-no_cell = Le contour ne contient aucune cellule de la surface.

outline-too_few_heights = { $n } points sur { $total } le long du contour ont une altitude ; trop peu pour un plan.

outline-overlap = Deux des contours se chevauchent.

outline-beyond_heights = { PERCENT($share, digits: 3) } % du contour est hors de la grille d'altitudes (limite { PERCENT($limit) } %).

outline-extent_empty = L'étendue { NUM($left, digits: 8) } { NUM($bottom, digits: 8) } { NUM($right, digits: 8) } { NUM($top, digits: 8) } est vide.

outline-option_empty = { OPTION($name) } est vide.

outline-neither_file_nor_corners = { OPTION($name, $given) } n'est ni un fichier ni une liste de sommets.

outline-no_area_in_file = Le fichier n'a pas de surface ; lignes et points n'enferment rien.

outline-too_few_corners = { OPTION($name, $given) } a moins de trois sommets.

outline-no_line_in_file = Le fichier n'a pas de ligne.

outline-single_place = { OPTION($name, $given) } est un seul lieu ; une ligne en demande deux.

outline-line_without_length = Ligne { $given } : deux lieux successifs sont identiques, ou elle n'en a qu'un.

outline-heights_in_no_map = Le fichier est en { $system } ; ces altitudes sont sur un plan de l'objet, pas dans une carte.

outline-hole_outside = Le trou { $hole } du contour sort de son bord près de { NUM($x, digits: 8) }, { NUM($y, digits: 8) }.

outline-holes_overlap = Les trous { $other } et { $hole } du contour se chevauchent près de { NUM($x, digits: 8) }, { NUM($y, digits: 8) }.

outline-only_holes = Les trous du contour le couvrent entièrement (près de { NUM($x, digits: 8) }, { NUM($y, digits: 8) }).
