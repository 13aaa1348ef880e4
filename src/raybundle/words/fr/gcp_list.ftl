gcp_list-empty = Le fichier est vide.

gcp_list-no_system = La première ligne n'indique pas de système de coordonnées.

gcp_list-no_point = Aucun point après la première ligne.

gcp_list-name_missing = Cette ligne n'a pas de nom de point, d'autres en ont.

gcp_list-coordinates_differ = Le point { $point } a d'autres coordonnées à la ligne { $earlier }.

gcp_list-too_few_columns = La ligne a { $n } colonnes : { $text }.

gcp_list-crs_missing = Un gcp_list.txt demande le système de coordonnées de ses points.
