snap-no_reference = Une vignette demande le même point dans une autre image.

snap-unknown_kind = Le type { $kind } est inconnu.

snap-image_type = Une image de type { $kind } et de forme ({ $shape }) ne peut pas être mesurée.

snap-outside = x = { $x_px }, y = { $y_px } est hors de l'image de { $width_px } x { $height_px } px.

snap-reach = reach_px = { $reach_px } n'est pas possible.
