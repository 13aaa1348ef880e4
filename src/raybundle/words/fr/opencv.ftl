opencv-matrix_size = La matrice annonce { $rows } x { $columns } éléments, mais en a { $n }.

opencv-size_expected = La largeur et la hauteur de l'image sont attendues ici.

opencv-no_matrix = Le fichier n'a pas de matrice de caméra.

opencv-fisheye = C'est l'étalonnage d'un fisheye.

opencv-matrix_form = La matrice de caméra n'a pas la forme [fx s cx; 0 fy cy; 0 0 1].

opencv-coefficient_count = Coefficients de distorsion : { $n } ; OpenCV en a { LIST($known, most: 8) }.

opencv-size_interchanged = Le point principal { $x_px }, { $y_px } px est au centre de { $height_px } x { $width_px } px.

opencv-principal_point_outside = Le point principal { $x_px }, { $y_px } px est hors du format { $width_px } x { $height_px } px.
