optical_bar-corrections = Refraction is applied, aberration is not, as in the Ames Stereo Pipeline.

# $deviation = 0.01
optical_bar-rotation = iR is no rotation (deviation { NUM($deviation, digits: 2) }), or the image has a single column.
    .do = Correct iR and image_size.

# $degrees = 95.0
# $limit = 80.0
optical_bar-sweep = The sweep reaches { NUM($degrees, digits: 3) }° from its middle; { NUM($limit, digits: 2) }° are possible.
    .do = Correct pitch, f or image_center.
