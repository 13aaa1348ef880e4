image-unknown_camera = Image { $image } : la caméra { $camera } manque.

image-point_not_finite = Image { $image } : un point image n'est pas fini.

image-in_two_frames = Image { $image } : figure dans deux frames.

image-camera_differs = Image { $image } : caméra { $camera }, mais { $frame_camera } dans son frame.

image-angles_incomplete = Image { $image } : { $n } angle(s) sur 3.

image-held_without_orientation = Image { $image } : fixée, mais son orientation externe est incomplète.

image-file_frame_incomplete = Image { $image } : { $n } parmi { $columns }.

image-scan_incomplete = Image { $image } : numérisation aux colonnes incomplètes.

image-affine_singular = Image { $image } : la transformation affine du scan n'est pas inversible.

image-file_size_differs = Image { $image } : { NUM($width_px, digits: 6) } x { NUM($height_px, digits: 6) } px contre { $camera_width_px } x { $camera_height_px } px.

image-points_in_line = Tous les points objet de { $n } image(s) sont alignés : { LIST($images, most: 5) }.

image-too_few_points = { $n } image(s) ont trop peu de points image : { $images }.

image-points_and_unknowns = { $images } : { $n } points image pour { $unknowns } inconnues

image-not_oriented = L'image { $image } n'a pas d'orientation externe.

image-photograph_missing = Image { $image } : sa photographie n'est pas dans les dossiers du projet.
