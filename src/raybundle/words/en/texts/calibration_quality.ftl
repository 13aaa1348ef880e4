# $grade = "good"
calibration_quality-grade = { $grade ->
        [good] good
        [usable] usable
        [weak] weak
        *[not_determinable] not determinable
    }

# $camera = "A"
# $grade = "good"
calibration_quality-camera_grade = Camera { $camera }: { $grade ->
        [good] good
        [usable] usable
        [weak] weak
        *[not_determinable] not determinable
    }

# $camera = "A"
calibration_quality-of_camera = Camera { $camera }:

calibration_quality-title = Quality of the calibration

calibration_quality-limits = Limits of this verdict

calibration_quality-weaknesses = weaknesses

calibration_quality-stability = Stability

calibration_quality-same_setting = Zoom, focus, stabilisation and temperature change a lens. Calibrate with the settings of use.

calibration_quality-edge = Edge of the format

calibration_quality-extrapolated = Beyond the farthest image point, distortion is extrapolated and its σ is too small.

# $names = ["c", "x0"]
# $whole = false
calibration_quality-head_not_determinable = Not determinable: { $whole ->
        [yes] the interior orientation
        *[no] { LIST($names, most: 8) }
    }.
    .do = Do not use this calibration for other photographs; take the proposed photographs first.

# $typical_px = 0.0056
# $largest_px = 0.032
# $sigma_px = 0.0061
calibration_quality-head_figures = Error of projection { NUM($typical_px, digits: 2) } px (median; largest { NUM($largest_px, digits: 2) }), image points { NUM($sigma_px, digits: 2) } px.

calibration_quality-head_weak = Weak: use it as approximate values only.
    .do = Estimate the camera again in each adjustment.

# $reach = 0.8
calibration_quality-head_part = Valid to { PERCENT($reach) } % of the distance to the corners.

# $reach = 0.8
# $inside_px = 0.06
calibration_quality-head_inside = Good to { PERCENT($reach) } % of the distance to the corners ({ NUM($inside_px, digits: 2) } px), usable beyond.
    .do = Measure points in the corners.

# $px = 0.2
calibration_quality-head_usable = Usable for measurements to about { NUM($px, digits: 2) } px.

# $px = 0.084
calibration_quality-head_good = Good: may be held for measurements to { NUM($px, digits: 2) } px.

# $symbol = "K3"
# $known = true
# $std = 0.16
# $unit = "mm"
calibration_quality-not_determinable = { $symbol } is not determinable and is held{ $known ->
        [yes] {" "}(standard deviation { NUM($std, digits: 2) } { $unit })
        *[no] {""}
    }.

# $n = 4
# $least = 6
calibration_quality-few_photographs = { $n } photographs are few; a calibration needs { $least } to 20.

# $sure_px = 0.4
# $certainty = 0.95
# $likely_px = 0.2
# $unstable = false
calibration_quality-uncertain = Largest error over the format: { NUM($sure_px, digits: 2) } px ({ PERCENT($certainty) } % certainty; expected { NUM($likely_px, digits: 2) } px).
    .do = { $unstable ->
            [yes] {""}
            *[no] Take more convergent and rolled photographs, or measure more precise image points.
        }

# $reach = 0.8
calibration_quality-reach = Image points reach { PERCENT($reach) } % of the distance to the corners; distortion beyond is extrapolated.

# $coverage = 0.6
calibration_quality-coverage = Image points cover { PERCENT($coverage) } % of the format.

calibration_quality-not_rolled = No photograph is rolled by 90° about the camera axis.
    .why = Principal point and decentring are correlated with the orientations.

# $angle_deg = 8
calibration_quality-no_convergence = The camera axes hardly converge: all within { NUM($angle_deg, digits: 2) }° of their mean.

# $symbol = "c"
# $other = "station"
# $correlation = 0.97
calibration_quality-coupled = { $symbol } is correlated with { $other ->
        [station] the station along the camera axis
        *[other] { $other }
    } ({ NUM($correlation, decimals: 2) }).

# $excess = 3.1
calibration_quality-contradicted = Photographs left out deviate { NUM($excess, digits: 2) } times more than predicted.
    .why = The calibration is not valid for other photographs.
    .do = Check whether the camera was the same in all photographs and the object stable.

# $ratio = 1.6
calibration_quality-few_views = Too few views: photographs left out fit { NUM($ratio, digits: 2) } times worse, as predicted.
    .do = Photograph the same points more often.

# $correlation = 0.3
# $factor = 1.4
calibration_quality-structure = Neighbouring residuals are correlated ({ NUM($correlation, decimals: 2) }): the model is incomplete.
    .why = Standard deviations are too small by a factor of at least { NUM($factor, digits: 2) }.

# $correlation = 0.4
# $rms_px = 0.05
calibration_quality-repeated = Residuals repeat at the same image position (correlation { NUM($correlation, decimals: 2) }, { NUM($rms_px, digits: 2) } px).
    .why = The distortion model is incomplete; standard deviations do not include this error.

# $likely_px = 0.05
# $worst_px = 0.09
calibration_quality-largest_error = Largest error over the format: expected { NUM($likely_px, digits: 2) } px; { NUM($worst_px, digits: 2) } px with 95 % certainty.

calibration_quality-image_sigma = standard deviation of a coordinate of median weight, from the residuals

calibration_quality-no_validation = too few photographs

# $rms_px = 0.06
# $folds = 5
calibration_quality-validation = Residuals of photographs left out ({ NUM($rms_px, digits: 2) } px) over those of the others, { $folds } folds.

# $excess = 3.1
calibration_quality-farther = They deviate { NUM($excess, digits: 2) } times more than predicted.

# $unstable = false
calibration_quality-as_predicted = They deviate as predicted{ $unstable ->
        [yes] , but the prediction is too wide to show that the camera was stable
        *[no] {""}
    }.

# $reach = 0.9
calibration_quality-covered = covered by image points; they reach { PERCENT($reach) } % of the distance to the corners

# $rolls = 4
# $angle_deg = 38
calibration_quality-views = { $rolls } of 4 quarter turns about the axis; axes within { NUM($angle_deg, digits: 2) }° of their mean

calibration_quality-unstable = More photographs of a camera that changes between them do not help.
    .do = Fix focus, zoom and stabilisation and photograph again, or use { OPTION("own_camera") }.

calibration_quality-no_advice = Four more photographs improve it by less than a tenth.

calibration_quality-photograph_next = What to photograph next

calibration_quality-photographs_in_order = photographs, in this order

calibration_quality-uncertainty_now = uncertainty now

calibration_quality-uncertainty_then = then

calibration_quality-smaller_by = smaller by

# $now_px = 9.2
calibration_quality-predicted = Largest predicted uncertainty over the format with these photographs, now { NUM($now_px, digits: 2) } px.

calibration_quality-predicted_of_open = Largest predicted uncertainty over the format with these photographs; now not determinable.

calibration_quality-calibrate_again = Take them and calibrate again.

calibration_quality-station = station along the camera axis

calibration_quality-coupled_with = correlated with

calibration_quality-coupling_effect = Correlated parameters do not affect points of this network, but other photographs.
