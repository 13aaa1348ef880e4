patb-photograph_line = Une photographie commence par son numéro et la constante de caméra en µm.

patb-image_point_line = Un point image demande trois mots : point, x et y.

patb-photograph_not_closed = La photographie { $photograph } n'est pas terminée par { $end }.

patb-camera_constant = { NUM($c_um, digits: 6) } n'est pas une constante de caméra en µm.

patb-rotation_missing = Photographie { $photograph } : la rotation manque.
