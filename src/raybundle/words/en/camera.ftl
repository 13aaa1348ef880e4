# $camera = "pano"
camera-panorama_not_supported = Camera { $camera } is a rotating panorama; this step or format cannot use it.
    .why = The camera is not left out automatically, so there is no result.
    .do = Remove the images of this camera from the block, then run the command again.

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
camera-principal_distance = Camera { $camera }: the camera constant is { $fx_px }, { $fy_px } px.
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

# $camera = "d5100-p"
# $width_px = 4000
# $height_px = 3000
# $other = "d5100"
# $other_width_px = 6000
# $other_height_px = 4000
# $turned_deg = 90
camera-no_turned_copy = The format of camera { $camera } is not that of { $other } turned by { $turned_deg }°.
    .why = They have { $width_px } x { $height_px } px and { $other_width_px } x { $other_height_px } px.
    .do = Use a camera of its own for these photographs.

# $camera = "rmk"
camera-scans_not_transformed = Camera { $camera }: its files are scans with a different position in each file.
    .why = Other programs have no affine interior orientation of an image.
    .do = Transform the scans to the camera frame first.

# $camera = "gopro"
# $model = "fisheye"
camera-turned_only_brown = Camera { $camera }: turned photographs are possible with model brown only, not { $model }.
    .do = Use the photographs as the sensor stored them.

# $camera = "d5100"
camera-covariance_not_positive = Camera { $camera }: the covariance of its calibration is not positive definite.
    .do = Export the calibration again.

# $camera = "scene_1"
# $name = "'K1'"
# $known = ["A0", "B0"]
camera-unknown_scene_parameter = Camera { $camera }: this scene has no parameter { $name }.
    .do = Use one of { LIST($known, most: 20) }.

# $camera = "d5200"
# $known = ["d5100"]
# $n = 1
camera-not_in_block = Camera { $camera } is not in the block.
    .do = { $n ->
        [0] Give a block with cameras
       *[other] Use one of { LIST($known, most: 9) }
     }.

# $camera = "d5100"
# $name = "K9"
# $known = ["c", "x0", "y0"]
camera-no_parameter = Camera { $camera } has no parameter { $name }.
    .do = Use one of { LIST($known, most: 30) }.

# $camera = "gopro"
# $parameter = "c"
# $model = "omnidirectional"
camera-constant_missing = Camera { $camera }: the camera constant { $parameter } is 0; model { $model } needs a value.
    .do = Write it in block.toml.

# $n = 2
# $cameras = ["d5100", "d7200"]
camera-several = The result has { $n } cameras and none is named.
    .do = Name one of { LIST($cameras, most: 10) }.

# $camera = "1"
# $model = "brown"
# $names = ["f"]
# $known = ["c", "x0", "y0"]
camera-symbols_unknown = Camera { $camera }: model { $model } has no parameter { LIST($names, most: 3) }.
    .do = Use { LIST($known, most: 30) }.

# $camera = "d3"
# $known = ["d5100", "d7200"]
camera-unknown = There is no camera { $camera }.
    .do = Use one of { LIST($known, most: 10) }.

# $camera = "d5100"
camera-interior_per_image = Camera { $camera }: each image has an interior orientation of its own.
    .do = Name an image.

# $camera = "d5100"
# $image = "IMG_1"
camera-no_interior_of_image = Camera { $camera }: image { $image } has no interior orientation of its own.
    .do = Leave the image out.

# $camera = "line"
# $parameters = ["c = 50", "vy = 0"]
camera-no_ray = Camera { $camera }: with these parameters an image point has no definite ray.
    .why = A pushbroom sensor that does not move (vy = 0) is such a case: { LIST($parameters, most: 30) }.
    .do = Give approximate values near the true ones.

# $camera = "d5100"
# $model = "spline"
camera-parameters_of_image = Camera { $camera }: model { $model } has no parameters of single images.
    .do = Remove per_image, or choose another model.

# $camera = "pano"
# $width_mm = 700.0
# $turns = 2.2
# $c_mm = 50.0
# $limit = 1.1
# $whole_turn_c_mm = 111.4
camera-too_many_turns = Camera { $camera }: the format ({ NUM($width_mm, digits: 4) } mm) spans { $turns } turns (limit { $limit }).
    .why = This follows from c = { NUM($c_mm, digits: 4) } mm.
    .do = For one turn, give c = width / (2 pi) = { NUM($whole_turn_c_mm, digits: 4) } mm.

# $camera = "phone"
# $parameters = ["vx", "vy"]
camera-no_read_out_time = Camera { $camera }: the read-out time r is 0.
    .why = No observation then determines { $parameters }.
    .do = Give r (read-out time over the height of the format, s/mm), or use the model without rolling shutter.

# $camera = "line"
camera-no_motion = Camera { $camera }: the velocity vy is 0.
    .why = All lines of an image then show the same line of the object.
    .do = Give vy, the length on the ground per millimetre of the image.

# $camera = "d5100"
camera-no_covariance = Camera { $camera } has no covariance matrix.
    .do = Calibrate it with statistics.

# $model = "brwon"
# $known = ["auto", "brown", "fisheye"]
camera-calibration_model_unknown = Sensor model { $model } is unknown.
    .do = Give one of { LIST($known, most: 30) }.

# $model = "panorama"
# $known = ["auto", "brown", "fisheye"]
camera-not_by_targets = Sensor model { $model } cannot be calibrated from photographs of targets.
    .why = It does not image everything at one time from one place.
    .do = Give one of { LIST($known, most: 30) }, or run raybundle adjust with a block that uses { $model }.

# $camera = "d5100"
# $model = "fisheye"
camera-model_not_fitted = Camera { $camera }: model { $model } cannot be fitted to the approximate values.
    .do = Give another model.

# $name = "'est'"
# $known = ["east", "west"]
camera-trajectory_unknown = The block has no trajectory { $name }.
    .do = Add a table [trajectories.ID], or name one of { LIST($known, most: 20) }.

# $name = "'nadr'"
# $known = ["nadir"]
camera-mount_unknown = The block has no mount { $name }.
    .do = Add a table [mounts.ID], or name one of { LIST($known, most: 20) }.

# $name = "'east'"
camera-trajectory_of_lines = Only line scanners (model = "linescan") share a trajectory; { $name } was named by another scene.
    .do = Delete the key, or give a file with the orbit or flight of a line scanner.

# $camera = "nadir"
# $name = "east"
camera-instrument_missing = Camera { $camera } takes parameters from { $name }, which is not in the block.
    .do = Add { $name } to the instruments of the block.
