label-accuracy = Exactitude

label-adjusted_minus_given = compensé moins donné

label-camera = caméra

label-check_points = points de contrôle

label-coordinate = coordonnée

label-format = format

label-given = donné

label-heading_cameras = Caméras

label-image_points = points image

label-known_lengths = Longueurs connues

label-leave_one_out = validation croisée

label-length = longueur

label-object_points = points objet

label-photographs = photographies

label-point = point

label-precision = Précision

label-projection_uncertainty = incertitude de projection

label-relative_precision = précision relative

label-role = rôle

label-standard_deviation = écart-type
