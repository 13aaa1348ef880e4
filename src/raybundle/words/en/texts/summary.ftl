# $images = 7
# $points = 231
# $observations = 1530
# $rejected = 3
summary-adjusted = Adjusted: { $images } { $images ->
        [one] image
        *[other] images
    }, { $points } { $points ->
        [one] object point
        *[other] object points
    }, { $observations } image observations{ $rejected ->
        [0] {""}
        *[other] , { $rejected } rejected
    }.

# $rms = 0.84
# $unit = "mm"
# $n = 5
summary-accuracy_of_check_points = Accuracy at { $n } { $n ->
        [one] check point
        *[other] check points
    }: { NUM($rms, digits: 2) } { $unit } (rms of a coordinate).

# $rms = 0.84
# $median = 0.62
# $few = false
# $unit = "mm"
# $free_scale = false
summary-precision = Standard deviation of object points: { $few ->
        [yes] { NUM($median, digits: 2) } { $unit } (median of a coordinate; rms { NUM($rms, digits: 2) })
        *[no] { NUM($rms, digits: 2) } { $unit } (rms of a coordinate)
    }{ $free_scale ->
        [yes] , scale arbitrary
        *[no] {""}
    }.

summary-no_statistics = No standard deviations: statistics are off.

summary-no_object_points = No object point is estimated.

# $images = 7
# $images_given = 8
# $points = 231
# $points_given = 240
# $observations = 1530
# $observations_given = 1600
# $rejected = 3
summary-counts = Used: { $images } of { $images_given } images, { $points } of { $points_given } object points, { $observations } of { $observations_given } observations.
    .why = { $rejected ->
            [0] {""}
            *[other] Rejected observations: { $rejected } (observations.csv).
        }

# $known = true
# $sigma0 = 1.024
# $sigma_px = 0.06
# $sized = true
# $sigma_um = 0.3
# $one = true
# $redundancy = 2310
summary-sigma0 = { $known ->
        [yes] sigma0 = { NUM($sigma0, digits: 4) }
        *[no] sigma0 cannot be estimated
    }, a priori { $sized ->
        [yes] { NUM($sigma_um, digits: 2) } um =
        *[no] {""}
    } { NUM($sigma_px, digits: 2) } px{ $one ->
        [yes] {""}
        *[no] {" "}(median)
    }, redundancy { $redundancy }.

# $datum = "control"
summary-datum = Datum: { $datum }.

# $x = 0.8
# $y = 0.7
# $z = 1.1
# $unit = "mm"
# $free_scale = false
summary-precision_of_axes = Standard deviation of object points (rms): X { $x }, Y { $y }, Z { $z } { $unit }{ $free_scale ->
        [yes] , scale arbitrary
        *[no] {""}
    }.

# $n = 4
# $of = 231
# $share = 0.53
# $x = 0.5
# $y = 0.5
# $z = 0.7
# $unit = "mm"
summary-few_points = { $n } of { $of } points contribute { PERCENT($share) } % of the variance; median X { $x }, Y { $y }, Z { $z } { $unit }.

# $n = 16000
# $std = 0.8
# $std_unit = "mm"
# $extent = 12.8
# $extent_unit = "m"
# $omitted = 0.05
# $class_name = "high"
summary-relative_precision = Relative precision 1 : { $n } (mean standard deviation { $std } { $std_unit }, largest extent { $extent } { $extent_unit }).
    .why = { $class_name ->
            [none] {""}
            *[other] Class: { $class_name }.
        } { $omitted ->
            [0] {""}
            *[other] The { PERCENT($omitted) } % least precise points are not in the mean.
        }

# $cause = "rig"
summary-noise_white = White noise is assumed: { $cause }.

# $factor = 1.8
summary-noise_neighbours = Standard deviations contain errors that neighbouring points share (variance times { NUM($factor, digits: 2) }).

# $sigma_px = 0.08
summary-noise_smooth = Standard deviations contain smooth errors of { NUM($sigma_px, digits: 2) } px that differ from image to image.

# $sigma_px = 0.3
summary-noise_focus = Standard deviations contain a focus that varies by { NUM($sigma_px, digits: 2) } px.

# $kind = "centres"
# $factor = 1.4
summary-noise_factor = Standard deviations of { $kind ->
        [interior] the interior orientation
        [centres] projection centres
        *[points] object points
    }: { NUM($factor, digits: 2) } times those of white noise (median).

# $share = 0.2
summary-relief = Relief within windows more than doubles the standard deviation of { PERCENT($share) } % of the tie points.

# $axes = ["X", "Y", "Z"]
# $rms = [1.1, 1.2, 2.3]
# $n = 5
# $unit = "mm"
summary-check_points = Check points ({ $n }): rms difference in { $axes }: { $rms } { $unit }.

# $n = 4
summary-more = and { $n } more: { OPTION("verbose", "True") } shows them.

# $step = "Measure a scale bar."
summary-next = Next: { $step }

# $files = ["result", "result/report.html"]
summary-files = Written: { $files }.

# $project = "facade-project"
summary-next_surface = raybundle surface { $project } computes the surface.

summary-next_scale = Give a scale bar ({ OPTION("scale_bar", "A", "B", "LENGTH", "SIGMA") }) or control points for a true scale.

# $oriented = 11
# $of = 11
# $points = 5312
# $parts = 0
# $lost = 1
# $names = ["DSC_0007.JPG"]
summary-oriented = Oriented: { $oriented } of { $of } { $of ->
        [one] photograph
        *[other] photographs
    }, { $points } object points{ $lost ->
        [0] {""}
        *[other] ; not oriented: { LIST($names, most: 2) }
    }.
    .why = { $parts ->
            [0] {""}
            [one] One further part is not connected to it.
            *[other] { $parts } further parts are not connected to it.
        }

# $sigma_px = 0.21
summary-image_points = Standard deviation of an image coordinate: { NUM($sigma_px, decimals: 3) } px (from residuals).

# $oriented = 2
# $of = 3
summary-scenes = Satellite scenes in the block: { $oriented } of { $of }.

# $n = 4
# $folder = "project/part-2"
summary-part = { $n } { $n ->
        [one] photograph forms
        *[other] photographs form
    } a part of its own: { $folder }.

summary-try_xfeat = { OPTION("features", "xfeat") } matches photographs with wider baselines (pip install 'raybundle[learned]').

# $n = 2
# $names = ["F1", "F2"]
summary-marks_left_out = { $n } { $n ->
        [one] point with fewer than two marks is
        *[other] points with fewer than two marks are
    } not used: { $names }.

# $text = "P1 lies 3 m away."
summary-text = { $text }
