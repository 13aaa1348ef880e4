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

# $n = 1
# $images = ["IMG_1"]
# $limit_sigmas = 3.0
image-points_in_line = All object points of { $n } { $n ->
        [one] image
       *[other] images
     } lie on one straight line: { LIST($images, most: 5) }.
    .why = Within { $limit_sigmas } standard deviations the image can rotate about this line.
    .do = Measure points beside the line, observe projection centres, or leave the image out.

# $n = 1
# $images = ["IMG_1"]
image-too_few_points = { $n } { $n ->
        [one] image has
       *[other] images have
     } too few image points: { $images }.
    .why = An exterior orientation needs at least three.
    .do = Measure more points there, or leave the images out.

# $images = ["IMG_1"]
# $n = 2
# $unknowns = 6
image-points_and_unknowns = Images { $images }: { $n } image { $n ->
        [one] point
        *[other] points
    } for { $unknowns } unknowns.

# $image = "IMG_1"
image-not_oriented = Image { $image } has no exterior orientation.
    .do = Orient it first.

# $image = "img_07.jpg"
image-photograph_missing = Image { $image }: its photograph is not in the folders of the project.
    .do = Restore the photograph.
