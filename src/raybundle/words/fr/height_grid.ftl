height_grid-too_small = La grille d'altitudes a { $rows } lignes et { $columns } colonnes.

height_grid-no_cell_area = Les cellules de la grille d'altitudes sont sans surface : pas { $across } et { $down } m.

height_grid-empty = La grille d'altitudes ne contient aucune altitude.

height_grid-no_four_cells = Grille d'altitudes { $name } : il n'y a pas quatre cellules voisines avec altitude.

height_grid-void_cells = { $n } cellules sur { $total } n'ont pas d'altitude.

height_grid-no_common_cell = Aucune cellule n'a d'altitude ici et dans { $other }.

height_grid-identical = Toutes les altitudes sont identiques à celles de { $other }.

height_grid-file = C'est un fichier. Il faut une surface : le dossier de raybundle surface.
