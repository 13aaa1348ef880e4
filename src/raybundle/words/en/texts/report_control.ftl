report_control-title = Control, check points and groups of observations

report_control-none = Neither control, check points, scale bars nor projection centres were given.

# $kind = "distance"
# $title = "Scale bars"
report_control-kind = { $title }

# $kind = "distance"
# $what = "from–to"
report_control-object = { $what }

# $kind = "distance"
# $title = "Scale bars"
# $n = 120
report_control-all_rows = { report_control-kind }, all { $n } rows

report_control-leave_one_out = Leave-one-out: adjusted minus given if the point with all its coordinates had taken no part.

report_control-first_order = Computed to first order.

report_control-no_check_points = There are no check points; these differences replace them.

report_control-points_left_out = Leave-one-out, control point by control point

report_control-coordinate_left_out = Leave-one-out of a coordinate, with the others of its point: residual over redundancy number.
    .why = It reveals a single wrong coordinate. As an accuracy it is too optimistic where coordinates of a point support each other.

report_control-coordinates_left_out = Leave-one-out, coordinate by coordinate

report_control-asprs = Accuracy by ASPRS (2024), that of the check points included.

# $name = "RMSE_H"
# $rmse = 12.1
# $unit = "mm"
# $n = 30
report_control-rmse = { $name } = { $rmse } { $unit } from { $n } check { $n ->
        [one] point
        *[other] points
    }.

report_control-check_sigma_missing = Check points without a standard deviation of their own count with 0.

# $least = 30
report_control-check_points_needed = ASPRS requires { $least } check points or more; with fewer, this is no proof of accuracy.

# $n = 96
# $images = 24
report_control-marks = { $n } { $n ->
        [one] measurement
        *[other] measurements
    } of control points (red) and check points (green) in { $images } { $images ->
        [one] image
        *[other] images
    }.

report_control-marks_vectors = Vectors: residuals, adjusted minus measured; a cross: rejected.

# $n = 12
# $of = 40
report_control-marks_drawn = Drawn: the { $n } of { $of } images with the most measurements.

report_control-marks_heading = Measurements in the images

# $n = 9
report_control-held = { $n } { $n ->
        [one] coordinate is
        *[other] coordinates are
    } held as given, without residuals.

report_control-held_list = Held coordinates

# $n = 12
# $held = 3
report_control-observed = { $n } { $n ->
        [one] value
        *[other] values
    } observed, { $held } held.

# $rms = 0.94
report_control-rms_by_sigma = Residual over sigma: rms { NUM($rms, decimals: 2) }.

# $w = 2.1
report_control-largest_w = Largest |w|: { NUM($w, decimals: 2) }.

# $rms = 1.2
# $largest = 2.9
# $unit = "mm"
report_control-rms_residual = Residuals: rms { $rms } { $unit }, largest { $largest } { $unit }.

report_control-uncontrolled = All are needed to fix the datum; no other observation controls them.

report_control-largest_rows = The largest |w|

# $symbol = "c"
report_control-known_before = known before: { $symbol }

# $symbols = ["c"]
report_control-logarithms = Observed is the natural logarithm of { $symbols } in mm, of which a factor was known before.
    .why = Its sigma and residual are relative: 0.01 is about 1 %.

report_control-residual_note = Residual: adjusted minus given.

report_control-marked = Marked: |w| above its critical value for all tests together.

report_control-difference_note = d: adjusted minus given.

report_control-rejected_control = These points contradict the others: they are neither control nor check points.

report_control-rejected_heading = Rejected control points

report_control-largest_ratio = largest |d| / sigma

report_control-check_sigma_note = Its sigma contains that of the adjusted and that of the given coordinate.

# $n = 30
report_control-all_check_points = All { $n } check { $n ->
        [one] point
        *[other] points
    }

report_control-check_points = Check points

report_control-rms_ratio = rms of d / sigma

report_control-group_differs = differs from the others (1 %)

report_control-group_note = A marked group differs from all others together (F test, Förstner 1979).
    .why = Its weight is too high where its ratio exceeds theirs, otherwise too low.
    .do = Change its a-priori standard deviation.

# $n = 3
report_control-images_differ = { $n } { $n ->
        [one] image differs
        *[other] images differ
    } too: see the images under “Residuals”.

report_control-components = Variance components

# $kind = "camera"
# $other = "camera"
report_control-component_kind = { $kind ->
        [image_observations] image observations
        [camera] camera
        [point_class] point class
        [attitudes] attitudes
        [stations] projection centres
        [distances] distances
        [directions] directions
        [zenith_angles] zenith angles
        [slope_distances] slope distances
        [coordinate_differences] coordinate differences
        [parameters] parameters
        [relations] relations
        [control] control
        [deviations_of_single_images] deviations of single images
        [planes] planes
        [straight_lines] straight lines
        [plumb_lines] plumb lines
        [levels] levels
        [coordinates_of_networks] coordinates of networks
        *[other] { $other }
    }

# $name = "all"
# $other = "A"
report_control-component_group = { $name ->
        [all] all
        [tie_points] tie points
        [targets] targets
        [control_points] control points
        [check_points] check points
        *[other] { $other }
    }

# $degrees = "no"
# $system = "WGS 84 / UTM zone 32N (EPSG:32632)"
# $x = 400039.7
# $y = 5500031.3
# $z = 300.8
report_control-origin = X, Y, Z are local: east, north, up.
    .why = Their origin in { $system } is { $degrees ->
        [yes] { NUM($x, decimals: 7) }, { NUM($y, decimals: 7) }, { NUM($z, decimals: 3) }
       *[no] { NUM($x, decimals: 3) }, { NUM($y, decimals: 3) }, { NUM($z, decimals: 3) }
    }.
