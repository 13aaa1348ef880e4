calibration_remark-covariance_of_other_model = The covariance is not converted: it belongs to parameters of another model.

calibration_remark-no_correlations = The correlations are not written: the format holds standard deviations only.

calibration_remark-no_covariance = The covariance is not written: the format does not hold it.

# $side_mm = 36.0
calibration_remark-nominal_pixel = The pixel size is nominal: { $side_mm } mm along the longer side. Results in px do not depend on it.

calibration_remark-file_without_correlations = The file holds standard deviations but no correlations.

# $radius_px = 2200.0
calibration_remark-valid_radius = MicMac states a valid radius of { NUM($radius_px, decimals: 0) } px.

calibration_remark-inputs_not_read = The optimisation inputs of mrcal are not read, so the covariance is unknown.

calibration_remark-no_distortion = The file holds no distortion coefficients; 0 is assumed.

# $skew = 0.5
calibration_remark-skew = The skew { $skew } of the matrix is left out, because OpenCV's functions ignore it.

# $x_px = 310.0
# $y_px = 245.0
# $width_px = 1280
# $height_px = 960
# $another_size = true
# $other_width_px = 620
# $other_height_px = 490
calibration_remark-principal_point = The principal point { NUM($x_px, digits: 6) }, { NUM($y_px, digits: 6) } px is not near the centre of the format, { $width_px } x { $height_px } px.
    .do = { $another_size ->
        [yes] Check whether the matrix belongs to images of { $other_width_px } x { $other_height_px } px.
        *[no] {""}
    }

# $camera = "d5100"
# $largest_px = 0.02
calibration_remark-fitted = Camera { $camera } is fitted: largest deviation { NUM($largest_px, digits: 2) } px.

# $camera = "d5100-turned"
# $other = "d5100"
# $n = 2
# $images = ["a.jpg", "b.jpg"]
# $turned_deg = 90
# $width_px = 600
# $height_px = 400
calibration_remark-of_stored = Camera { $camera } is that of { $n } { $n ->
        [one] photograph
        *[other] photographs
    } stored { $turned_deg ->
        [0] at { $width_px } x { $height_px } px
        *[other] turned by { $turned_deg }°
    } ({ $images }).
    .do = Use camera { $other } for these only if their pixels are brought to its frame first.

# $other = "d5100"
# $n = 2
# $images = ["a.jpg", "b.jpg"]
# $turned_deg = 90
# $width_px = 600
# $height_px = 400
calibration_remark-not_of_stored = Camera { $other } is not that of { $n } { $n ->
        [one] photograph
        *[other] photographs
    } stored { $turned_deg ->
        [0] at { $width_px } x { $height_px } px
        *[other] turned by { $turned_deg }°
    } ({ $images }):

# $name = "b.toml"
# $width_px = 3000
# $height_px = 2000
# $other_width_px = 6000
# $other_height_px = 4000
calibration_remark-scaled = { $name } has { $width_px } x { $height_px } px and is compared scaled to { $other_width_px } x { $other_height_px } px.

# $camera = "d5100"
# $grade = "weak"
calibration_remark-not_good_enough = Camera { $camera } is not stored in the camera library: its calibration is { $grade ->
        [not_determinable] not determinable
        [weak] weak
        *[other] { $grade }
    }.

# $camera = "d5100"
calibration_remark-not_stored = Camera { $camera } is not stored in the camera library:
