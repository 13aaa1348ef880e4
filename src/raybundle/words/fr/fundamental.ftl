fundamental-too_few_points = { $n } points homologues sont donnés ; une matrice fondamentale en demande { $least }.

fundamental-one_point = Tous les points de la première image sont identiques.

fundamental-too_few_inliers = { $n } points homologues sur { $total } concordent avec une matrice fondamentale ; il en faut { $least }.

fundamental-homography = Une homographie explique { PERCENT($share) } % des points homologues (limite { PERCENT($limit) } %).
