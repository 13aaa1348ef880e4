# $value = "'a'"
calibration-no_list = { $value } is not a list of calibrated parameters.
    .do = Give a list of tables with parameter, value, sigma and correlations.

# $number = 2
calibration-incomplete_entry = Entry { $number } is not a calibrated parameter.
    .do = Give parameter, value, sigma and, as a list, correlations with the entries before it.

# $number = 3
# $n = 1
# $needed = 2
calibration-correlation_count = Entry { $number } has { $n } correlations; { $needed } are needed, with the parameters before it.
    .do = Complete the list.

calibration-not_positive_definite = The correlations do not form a positive definite matrix.
    .do = Correct them, or write more digits.

# $camera = "d5100"
# $width_px = 6000
# $height_px = 4000
# $known = ["1 (4000 x 3000 px)"]
calibration-format_differs = Stored calibration { $camera }: no photograph has its format, { $width_px } x { $height_px } px.
    .do = Give the calibration of a camera of the set: { $known }.

# $camera = "d5100"
# $n = 2
# $known = ["1 (6000 x 4000 px)", "2 (6000 x 4000 px)"]
calibration-several_cameras = Stored calibration { $camera } fits { $n } cameras.
    .do = Give it the id of one of them: { $known }.

# $camera = "d5100"
# $known = ["d5100 (6000 x 4000 px)"]
calibration-two_for_camera = Two stored calibrations fit camera { $camera }.
    .do = Give each the id of its camera: { $known }.

# $camera = "d5100"
# $width_px = 6000
# $height_px = 4000
# $given_width_px = 3000
# $given_height_px = 2000
calibration-size_differs = Camera { $camera } has { $width_px } x { $height_px } px, not { $given_width_px } x { $given_height_px } px.
    .do = Check that it is the calibration of this camera.

# $pixel_mm = 4.5
calibration-pixel_size = A pixel size of { $pixel_mm } mm is not possible.
    .do = Give the size in mm, such as 0.0045.

# $format = "australis"
calibration-one_model = Format { $format } has one distortion model; none can be chosen.
    .do = Omit the model.

# $format = "opencv"
# $model = "xyz"
# $known = ["radtan", "rational"]
calibration-model_unknown = Format { $format } has no model { $model }.
    .do = Use one of { LIST($known, most: 20) }.

# $format = "opencv"
# $suffixes = [".yaml", ".xml"]
calibration-suffix = Format { $format } is a file with another ending.
    .do = Give a name that ends in one of { $suffixes }.

# $camera = "d5100"
# $model = "radtan"
# $deviation_px = 0.45
# $rms_px = 0.12
# $limit_px = 0.1
calibration-deviation = Camera { $camera } as { $model } deviates by up to { $deviation_px } px (rms { $rms_px } px, limit { $limit_px } px).
    .do = Choose another format or model, or give { OPTION("approximate", "True") }.

# $n = 2
# $format = "opencv"
calibration-one_camera = Cameras to write: { $n }; a file of the format { $format } has exactly one.
    .do = Convert them one by one: { OPTION("camera", "ID") }.

calibration-second_camera = The file contains a second camera.
    .do = Give each camera in its own file.

# $parameter = "C"
# $n = 3
# $needed = 5
calibration-australis_row = Parameter { $parameter } has { $n } numbers; { $needed } are needed.
    .do = Give initial value, adjustment, final value and the two standard deviations.

# $missing = ["C", "XP"]
calibration-incomplete = The calibration report lacks { $missing }.
    .do = Give the complete report.

# $width_px = 6000
# $height_px = 4000
# $pixel_mm = [0.004, 0.004]
# $c_mm = -24.0
calibration-impossible_values = Format { $width_px } x { $height_px } px, pixel { $pixel_mm } mm or c = { $c_mm } mm is not possible.
    .do = Correct the value.

calibration-no_size = The file does not contain the image size.
    .do = Give { OPTION("format", "WIDTH", "HEIGHT") }.

# $width_mm = 36.0
# $height_mm = 24.0
# $width_px = 4000
# $height_px = 4000
# $ratio = 1.5
calibration-pixels_not_square = A format of { $width_mm } x { $height_mm } mm does not fit { $width_px } x { $height_px } px (pixel ratio { $ratio }).
    .do = Correct the image size.

calibration-no_camera = The file contains no camera.
    .do = Check that it is the right file; a TOML file has tables [cameras.ID].

# $width_px = 6000.0
# $height_px = 0.0
# $distance_px = -1200.0
calibration-size_or_distance = Format { NUM($width_px, digits: 8) } x { NUM($height_px, digits: 8) } px or camera constant { $distance_px } px is not possible.
    .do = Correct the value.

# $n = 2
calibration-camera_count = Cameras in this file: { $n }; exactly one is needed.
    .do = Give one camera per file.

calibration-no_covariance = This is not a covariance matrix: it must be symmetric and positive definite.
    .do = Export the calibration again.

# $names = ["opencv", "ros"]
# $known = ["colmap", "kalibr"]
calibration-format_unclear = The file could be one of several calibration formats: { $names }.
    .do = Choose one with { OPTION("read_as", "FORMAT", flag: "from") }: { LIST($known, most: 30) }.

# $known = ["colmap", "kalibr"]
calibration-format_not_recognised = The file is not recognised as a calibration.
    .do = Give its format with { OPTION("read_as", "FORMAT", flag: "from") }: { LIST($known, most: 30) }.

# $camera = "d5100"
calibration-not_estimated = Camera { $camera }: no parameter of the interior orientation was estimated with statistics.
    .do = Estimate parameters, and adjust with statistics=True.

# $first_px = [4000, 3000]
# $second_px = [2000, 1500]
calibration-formats_differ = Calibrations of { $first_px } px and { $second_px } px cannot be compared.
    .do = Scale one of them to the format of the other.

# $width_px = 1900
# $height_px = 1500
# $camera_width_px = 4000
# $camera_height_px = 3000
calibration-cropped_format = { $width_px } × { $height_px } px is no reduction of { $camera_width_px } × { $camera_height_px } px.
    .why = The format was cropped, so the principal point of the calibration does not hold for it.
    .do = Use photographs of the full format, or calibrate with photographs of the cropped format.

# $used = 20
# $of = 21
# $points = 2069
# $natural = false
calibration-used = Calibrated: { $used } of { $of } photographs, { $points } { $natural ->
        [yes] object points
        *[no] target points
    }.

# $camera = "d5100"
# $grade = "usable"
# $typical_px = 0.12
# $largest_px = 0.45
calibration-grade = Camera { $camera }: { $grade ->
        [not_determinable] not determinable; do not use it for other photographs.
        *[other] { $grade }, projection { NUM($typical_px, digits: 2) } px (median over the format; largest { NUM($largest_px, digits: 2) } px).
    }

# $n = 3
calibration-photograph_next = Take { $n } further { $n ->
        [one] photograph
        *[other] photographs
    }: { OPTION("verbose", "True") } lists them.

# $n = 2
# $cameras = ["d5100", "d7200"]
calibration-several = Cameras in this file: { $n }; none is named.
    .do = Name one with { OPTION("camera") }: { LIST($cameras, most: 20) }.

# $n = 2
# $photographed = 1
calibration-one_for_one = Cameras in this file: { $n }; cameras of the photographs: { $photographed }. One of each is possible.
    .do = Give the calibration of the one camera of the photographs.

# $n = 0
# $width_px = 6000
# $height_px = 4000
calibration-no_camera_of_size = Cameras of this file with { $width_px } x { $height_px } px, the size of the photograph: { $n }; one is needed.
    .do = Give the calibration of the camera of the photograph.

# $n = 2
# $least = 3
calibration-too_few_photographs = { $n } usable { $n ->
        [one] photograph
       *[other] photographs
    }; a calibration needs at least { $least }.
    .do = Take 10 to 20 photographs from different sides, some with the camera rolled by 90°.

calibration-spline_parameters = The parameters of model spline cannot be selected.
    .do = Omit { OPTION("parameters") } or { OPTION("model") }.

# $n = 1
# $photographs = 8
# $least = 6
# $families = ["aicon14"]
# $points = 40
# $unnamed = 12
calibration-too_few_points = { $n } of { $photographs } photographs show { $least } common points of { $families }; 2 are needed.
    .why = { $points } points were read, { $unnamed } without a code.
    .do = Name the printed targets ({ OPTION("target") }), and photograph them so that a dot or square is 10 px large.

# $angle_deg = 8.0
# $least_deg = 15.0
calibration-flat_views = The views of the flat object differ by { NUM($angle_deg, decimals: 0) }° only; { NUM($least_deg, decimals: 0) }° are needed.
    .why = From nearly one direction, camera constant and distance of a flat object cannot be separated.
    .do = Add convergent photographs: from left, right, above and below, 30° to 45° off the normal, some rolled by 90°.

calibration-not_possible = The camera cannot be calibrated from these photographs.
    .do = Take 6 to 20 photographs of the same points that converge by 30° to 45°, some rolled by 90°; exclude photographs named here.

# $camera = "d5100"
# $rms_px = 0.8
# $start_rms_px = 0.3
# $c_mm = 24.1
calibration-spline_worse = Camera { $camera }: model spline ends worse ({ NUM($rms_px, digits: 2) } px) than the start ({ NUM($start_rms_px, digits: 2) } px).
    .why = These photographs do not determine its surfaces (camera constant { $c_mm } mm).
    .do = Omit { OPTION("model") }, or add photographs that cover the format to its corners.

# $camera = "cam"
# $share = 0.92
calibration-inverse_in_part = Camera { $camera }: the distortion has an inverse for { PERCENT($share) } % of the format only.
    .do = Do not use image points outside of it.

# $name = "cam.toml"
calibration-file_unusable = { $name } is not usable.

# $name = "DSC_0001.JPG"
calibration-none_fits = The camera library has no calibration for { $name }.
    .do = Calibrate the camera, then store it with raybundle calibration add.

# $reason = "fold"
# $angle_deg = 42.1
# $finite = true
# $radius_px = 3100.0
# $corner_px = 3600.0
# $inside = true
calibration-validity = { $reason ->
        [none] The distortion is invertible over the whole format.
        [pole] The distortion has a pole { NUM($angle_deg, decimals: 1) } deg off the axis
        *[fold] The distortion folds over { NUM($angle_deg, decimals: 1) } deg off the axis
    }{ $reason ->
        [none] {""}
        *[other] { $inside ->
            [yes] , within the format.
            *[no] , beyond the format.
        }
    }
    .why = { $finite ->
            [yes] Radius { NUM($radius_px, decimals: 0) } px; the corners are at { NUM($corner_px, decimals: 0) } px.
            *[no] {""}
        }
