# $camera = "gopro"
# $width_px = 30000
# $height_px = 20000
# $camera_width_px = 4000
# $camera_height_px = 3000
# $limit = 4.0
undistort-too_large = Camera { $camera }: the undistorted image would have { $width_px } x { $height_px } px.
    .why = The photograph has { $camera_width_px } x { $camera_height_px } px; the limit is { $limit } times as many.
    .do = Use the area inside, or leave its images out.

# $width_px = 3000
# $height_px = 2000
# $camera = "d5100"
# $camera_width_px = 6000
# $camera_height_px = 4000
undistort-size_differs = The file has { $width_px } x { $height_px } px, camera { $camera } { $camera_width_px } x { $camera_height_px } px.
    .do = Give the photographs of the block.
