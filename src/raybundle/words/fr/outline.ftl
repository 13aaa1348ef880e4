outline-crosses_itself = { $name } se croise aux côtés partant des sommets { $first } et { $second }.

outline-no_area = { $name } n'enferme aucune surface.

outline-not_one = Le fichier a { $n } lignes et surfaces ; il en faut une seule.

outline-no_pair = { $text } n'est pas une paire de nombres.

outline-empty = Le fichier ne contient pas de coordonnées.

outline-no_cell = Le contour ne contient aucune cellule de la surface.

outline-too_few_heights = { $n } points sur { $total } le long du contour ont une altitude ; trop peu pour un plan.
