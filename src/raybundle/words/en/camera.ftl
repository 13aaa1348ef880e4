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

# $camera = "1"
# $kind = "fisheye"
# $format = "OPF"
camera-not_in_format = Camera { $camera } is a { $kind ->
        [scene] satellite scene
       *[fisheye] fisheye camera
     }; { $format } cannot represent it.
    .do = Leave its images out, or choose another format.

# $camera = "d5100"
# $table = "cameras.toml"
camera-constant_unknown = Camera { $camera }: the camera constant is unknown.
    .do = Add [cameras.{ $camera }] to { $table } in this folder.

# $camera = "1"
# $width_px = 0
# $height_px = 3000
camera-format_size = Camera { $camera }: an image format of { $width_px } x { $height_px } px is not possible.
    .do = Correct width and height.

# $camera = "1"
# $parameters = [4000.0, 2000.0]
# $width_px = 6000
# $height_px = 3000
camera-equirectangular_size = Camera { $camera }: parameters { $parameters } differ from the image format { $width_px } x { $height_px } px.
    .do = Correct one of them.

# $camera = "1"
# $fx_px = -1200.0
# $fy_px = 1200.0
camera-principal_distance = Camera { $camera }: the principal distance is { $fx_px }, { $fy_px } px.
    .do = Give values above 0.

# $camera = "1"
# $parameter = "omega"
# $model = "FOV"
# $value = 4.0
# $least = 0.0
# $most = 3.14
camera-parameter_limits = Camera { $camera }: { $parameter } of model { $model } is { $value }, outside { $least } to { $most }.
    .do = Correct the value.

# $camera = "1"
# $model = "RAD_TAN"
# $known = ["PINHOLE", "OPENCV"]
camera-model_unknown = Camera { $camera }: the camera model { $model } is not supported.
    .do = Use one of { LIST($known, most: 20) }.

# $camera = "1"
# $n = 3
# $model = "PINHOLE"
# $needed = 4
camera-parameter_count = Camera { $camera }: { $n } parameters are given; model { $model } has { $needed }.
    .do = Correct the line.

camera-pixel_size_missing = The width and height of a pixel are needed.
    .do = Give, for example, pixel_mm = [0.005, 0.005].

# $pattern = "left_*"
# $names = ["img_01.jpg", "img_02.jpg"]
camera-pattern_without_photograph = No photograph matches the pattern { $pattern } of a camera.
    .do = Correct the pattern; names are { LIST($names, most: 3) }.

# $photograph = "left_01.jpg"
# $first = "left_*"
# $second = "*_01*"
camera-two_patterns = Photograph { $photograph } matches two patterns of cameras, { $first } and { $second }.
    .do = Make the patterns exclusive.
