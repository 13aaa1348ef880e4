metashape-no_calibration = Aucun capteur n'a d'étalonnage.

metashape-p3_p4 = Le paramètre de distorsion { $parameter } n'est pas pris en charge.

metashape-sizes_differ = L'étalonnage a { $width_px } x { $height_px } px, son capteur { $sensor_width_px } x { $sensor_height_px } px.

metashape-no_similarity = Ce n'est pas une similitude : échelle positive, rotation orthogonale.

metashape-cameras_disabled = Toutes les caméras sont désactivées.

metashape-no_calibrated_camera = Aucune caméra n'a de capteur étalonné.

metashape-unit_length = La longueur de l'unité n'est pas un nombre positif.
