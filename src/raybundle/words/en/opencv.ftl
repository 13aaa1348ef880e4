# $rows = 3
# $columns = 3
# $n = 8
opencv-matrix_size = The matrix announces { $rows } x { $columns } elements, but has { $n }.
    .do = Check that the file is complete.

opencv-size_expected = The width and height of the image are expected here.
    .do = Give two whole numbers.

# $names = ["camera_matrix", "K"]
opencv-no_matrix = The file has no camera matrix.
    .do = Name it as one of { LIST($names, most: 12) }.

opencv-fisheye = This is the calibration of a fisheye.
    .do = Give { OPTION("read_as", "opencv-fisheye", flag: "from") }.

opencv-matrix_form = The camera matrix has not the form [fx s cx; 0 fy cy; 0 0 1] with positive fx, fy.
    .do = Correct it.

# $n = 7
# $known = [4, 5, 8, 12, 14]
opencv-coefficient_count = Distortion coefficients: { $n }; OpenCV has { LIST($known, most: 8) }.
    .do = Check that the file is complete, or give the fisheye model.

# $x_px = 2000.0
# $y_px = 3000.0
# $width_px = 6000
# $height_px = 4000
opencv-size_interchanged = The principal point { $x_px }, { $y_px } px is near the centre of { $height_px } x { $width_px } px.
    .why = The format given is { $width_px } x { $height_px } px.
    .do = Interchange width and height.

# $x_px = 7000.0
# $y_px = 3000.0
# $width_px = 6000
# $height_px = 4000
opencv-principal_point_outside = The principal point { $x_px }, { $y_px } px is outside the format { $width_px } x { $height_px } px.
    .do = Give the image size that belongs to the matrix.
