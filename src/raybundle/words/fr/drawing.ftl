drawing-no_source = Il n'y a rien à dessiner.

drawing-planes_differ = L'image est dans un autre plan ou système de coordonnées que { $other }.

drawing-no_extent = Il n'y a ni points ni lignes à dessiner.

drawing-no_area = La surface à dessiner est de { $width } x { $height } ; il faut des valeurs supérieures à 0.

drawing-several_results = On dessine les points et lignes d'un seul résultat ; celui-ci est le second.

drawing-plane_of_picture = { OPTION($setting) } définit le plan d'un résultat ; une image a son propre plan.

drawing-grid_too_dense = Les lignes de la grille { $grid } seraient à { NUM($apart_mm, digits: 2) } mm sur le papier (au moins { $least_mm } mm).

drawing-does_not_fit = L'objet de { $width_m } x { $height_m } m ne tient pas sur { $paper }.

drawing-fitting_scale = Une échelle plus petite : { OPTION("scale", $scale) }.

drawing-fitting_paper = Un papier plus grand : { OPTION("paper", $paper) }.

drawing-joined_sheets = Des feuilles à assembler : { OPTION("several", "True") }.

drawing-title_block = Moins de texte dans le cartouche.
