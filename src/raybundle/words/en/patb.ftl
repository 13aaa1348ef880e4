patb-photograph_line = A photograph begins with its number and the camera constant in µm.
    .do = Complete this line.

# $end = "-99"
patb-image_point_line = An image point needs three words: point, x and y.
    .do = Complete the line, or add { $end } after the photograph before it.

# $photograph = "'7'"
# $end = "-99"
patb-photograph_not_closed = Photograph { $photograph } is not closed by { $end }.
    .do = Get the complete file.

# $c_um = -153000.0
patb-camera_constant = { NUM($c_um, digits: 6) } is no camera constant in µm.
    .do = Give a positive value in µm.

# $photograph = "'7'"
patb-rotation_missing = Photograph { $photograph }: the rotation is missing.
    .do = Get the complete file.
