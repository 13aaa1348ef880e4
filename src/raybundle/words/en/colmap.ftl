# $image = "img 07.jpg"
colmap-blank_in_name = Image { $image } has a blank in its name; text files of COLMAP cannot represent it.
    .do = Write the binary format (colmap), or rename the photographs.

colmap-no_model = The folder has no COLMAP model.
    .do = Give a folder with cameras, images and points3D, all .bin or all .txt.

# $other = "rigs.bin"
colmap-file_missing = The file is missing; { $other } needs it.
    .do = Copy it into the folder.

colmap-camera_line = A camera needs number, model, width, height and parameters.
    .do = Complete this line.

colmap-image_line = An image needs number, 4 + 3 numbers, camera and name.
    .do = Complete this line.

# $n = 7
colmap-image_points_line = The line of image points has { $n } numbers; each point needs three: x, y and point number.
    .do = Correct this line, or export the model from COLMAP again.

colmap-point_line = A point needs number, 3 coordinates, 3 colours and an error.
    .do = Complete this line.
