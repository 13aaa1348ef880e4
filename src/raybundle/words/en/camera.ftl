# $camera = "pano"
camera-panorama_not_supported = Camera { $camera }: this format has no model for a rotating panorama.
    .do = Export the frame images alone.

# $camera = "d5100"
# $c_mm = -24.0
# $A = 3.0
camera-no_lens = Camera { $camera }: c = { $c_mm } mm and A = { $A } are no valid interior orientation.
    .do = Give c above 0 and A near 0.

# $name = "camera d5100"
# $covered = 0.61
# $least = 0.95
camera-distortion_not_invertible = { $name }: the distortion can be inverted over { PERCENT($covered) } % of the format only ({ PERCENT($least) } % needed).
    .do = Calibrate it again with fewer coefficients.

# $name = "camera gopro"
camera-wider_than_projection = { $name } images directions 89° or more off its axis.
    .why = A central projection cannot show them.
    .do = Use a fisheye model, or leave its images out.

# $camera = "d5100"
# $n = 5
# $deviation_px = 0.4
# $limit_px = 0.05
camera-opencv_deviation = Camera { $camera }: OpenCV's model with { $n } coefficients deviates by up to { NUM($deviation_px, digits: 2) } px (limit { $limit_px } px).
    .do = Use more coefficients, or calibrate with the model rational.

# $fisheye = false
# $n = 7
# $known = [4, 5, 8, 12, 14]
camera-opencv_coefficients = OpenCV has no { $fisheye ->
        [yes] fisheye
       *[no] camera
     } model with { $n } coefficients.
    .do = Use one of { LIST($known, most: 8) }.
