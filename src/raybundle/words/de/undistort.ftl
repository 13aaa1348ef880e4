undistort-too_large = Kamera { $camera }: Das entzerrte Bild hätte { $width_px } x { $height_px } px.
    .why = Die Aufnahme hat { $camera_width_px } x { $camera_height_px } px; die Grenze ist das { $limit }-fache.
    .do = Den Bereich inside verwenden oder ihre Bilder weglassen.

undistort-size_differs = Die Datei hat { $width_px } x { $height_px } px, Kamera { $camera } { $camera_width_px } x { $camera_height_px } px.
    .do = Die Aufnahmen des Blocks angeben.
