# $range_mm = [70.0, 24.0]
# $resolution_mm = 0.1
zoom-range = { $range_mm } mm with a resolution of { $resolution_mm } mm is not a range of focal lengths.
    .do = Give low and high above 0, in this order.

# $n = 14
# $most = 12
zoom-coefficient_count = Coefficients: { $n }; 1 to { $most } are possible.
    .do = Correct the list.

# $camera = "d5100"
# $focal_mm = 70.0
# $low_mm = 18.0
# $high_mm = 55.0
zoom-out_of_range = Camera { $camera }: EXIF focal length { NUM($focal_mm, digits: 4) } mm is outside the calibrated { NUM($low_mm, digits: 4) } to { NUM($high_mm, digits: 4) } mm.
    .do = Calibrate a setting there, or use photographs within the calibrated range.

# $n = 2
# $least = 3
zoom-too_few_settings = { $n } settings of the zoom lens are given; { $least } are needed.
    .do = Add calibrations, both ends of the zoom range among them.

# $focal_mm = 35.0
zoom-setting_given_twice = Two calibrations have the EXIF focal length { $focal_mm } mm.
    .do = Adjust their photographs together.

# $first_mm = 18.0
# $second_mm = 35.0
# $first = ["c", "x0"]
# $second = ["c"]
zoom-settings_differ = The calibrations at { $first_mm } and { $second_mm } mm differ in format, sensor model or free parameters.
    .why = Free parameters: { LIST($first, most: 20) } and { LIST($second, most: 20) }.
    .do = Calibrate all settings in the same way.

# $parameters = ["K1"]
# $first_mm = 18.0
# $second_mm = 35.0
zoom-held_values_differ = { LIST($parameters, most: 20) } held at different values at { $first_mm } and { $second_mm } mm.
    .do = Hold these parameters at the same values, or estimate them in all settings.

zoom-lenses_differ = The settings belong to different cameras or lenses (EXIF).
    .why = The zoom lens is not added to the library.
    .do = Calibrate all settings with the same camera and lens.

# $camera = "d5100"
zoom-focal_length_unknown = Camera { $camera }: the EXIF focal length is unknown.
    .do = Give { OPTION("focal", "MM") } once for each camera.
