image_point-out_of_range = { $x }, { $y } ne sont pas des coordonnées image en { $unit ->
        [mm] mm
       *[um] µm
     } (maximum { $largest } { $unit ->
        [mm] mm
       *[um] µm
     }).

image_point-sigma_not_positive_px = L'écart-type des points image est { $sigma_px } px.

image_point-covariance_not_positive = Image { $image }, point { $point } : la matrice de covariance n'est pas définie positive.

image_point-far_off = Le point { $point } de l'image { $image } s'écarte de { PERCENT($share) } % de la diagonale.
