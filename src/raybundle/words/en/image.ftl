# $image = "'img_07'"
# $camera = "3"
image-unknown_camera = Image { $image } refers to camera { $camera }, which is missing.
    .do = Correct the number, or add the camera.

# $image = "7"
image-point_not_finite = Image { $image }: an image point is not finite.
    .do = Export the file again.

# $image = "img_07"
image-in_two_frames = Image { $image } is in two frames.
    .do = Export the model again.

# $image = "img_07"
# $camera = "1"
# $frame_camera = "2"
image-camera_differs = Image { $image } has camera { $camera }, but camera { $frame_camera } in its frame.
    .do = Export the model again.

# $image = "img_07"
# $n = 1
image-angles_incomplete = Image { $image } has { $n } of 3 angles.
    .do = Give all three, or none.

# $image = "img_07"
image-held_without_orientation = Image { $image } is fixed, but its exterior orientation is incomplete.
    .do = Complete it, or leave the column held empty.

# $image = "img_07"
# $n = 1
# $columns = ["turned_deg", "file_width_px", "file_height_px"]
image-file_frame_incomplete = Image { $image } has { $n } of { $columns }.
    .do = Give all three, or none.

# $image = "img_07"
# $needed = ["a", "b", "c"]
image-scan_incomplete = Image { $image } is a scan, but not all its columns have values.
    .do = Fill in { LIST($needed, most: 12) }, or none of them.

# $image = "img_07"
image-affine_singular = Image { $image }: the affine transformation of the scan has no inverse.
    .do = Measure the fiducial marks again.

# $image = "img_07"
# $width_px = 3000.0
# $height_px = 1999.0
# $turned_deg = 90.0
# $camera_width_px = 6000
# $camera_height_px = 4000
image-file_size_differs = Image { $image }: a file of { NUM($width_px, digits: 6) } x { NUM($height_px, digits: 6) } px does not fit { $camera_width_px } x { $camera_height_px } px.
    .why = The camera has this format; the file is rotated by { $turned_deg }°.
    .do = Correct the size or the rotation.
