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
