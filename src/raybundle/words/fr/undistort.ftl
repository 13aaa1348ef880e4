undistort-too_large = Caméra { $camera } : l'image corrigée aurait { $width_px } x { $height_px } px.

undistort-size_differs = Le fichier a { $width_px } x { $height_px } px, la caméra { $camera } { $camera_width_px } x { $camera_height_px } px.
