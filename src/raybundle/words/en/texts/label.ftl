label-accuracy = Accuracy

label-adjusted = adjusted

label-adjusted_minus_given = adjusted minus given

label-allowed = allowed

label-angle = angle

label-at_point = at point

label-axis = axis

label-block = block

label-blunders = Blunders

label-camera = camera

label-cameras = cameras

label-check_points = check points

label-common_points = common points

label-control = Control

label-coordinate = coordinate

label-correlation = correlation

# $n = 12
label-count_of_points = { $n } { $n ->
        [one] point
        *[other] points
    }

label-cross_validation = cross-validation

label-datum = datum

label-error = error

label-figure = figure

label-file = file

label-fit = Fit

label-format = format

label-free_unit = units

label-from = from

label-given = given

label-group = group

label-heading_adjusted = Adjusted

label-heading_cameras = Cameras

label-held = held

label-image = image

label-image_observations = image observations

label-image_points = image points

label-images = images

# $value = 0.0005
label-in_free_units = { NUM($value) } units

label-intersection_angle = intersection angle

label-known_lengths = Known lengths

label-largest = largest

label-largest_w = largest |w|

label-leave_one_out = leave-one-out

label-length = length

label-level = level

label-mdb_note = MDB: minimal detectable bias.

label-mean = mean

label-meaning = meaning

label-measured = measured

label-median = median

label-model = model

# $n = 38
# $of = 40
label-n_of = { $n } of { $of }

label-name = name

label-number = number

label-object_points = object points

label-observations = observations

label-observed = observed

label-pairs = pairs

label-parameter = parameter

label-photograph = photograph

label-photographs = photographs

label-point = point

label-point_standard_deviation = standard deviation of object points

label-points = points

label-precision = Precision

label-projection_uncertainty = uncertainty of projection

label-quantity = quantity

label-ratio = ratio

label-rays = rays

label-reason = reason

label-redundancy = redundancy

label-rejected = rejected

label-relative_precision = relative precision

label-remedy = remedy

label-residual = residual

label-result = result

label-role = role

# $role = "tie"
label-role_of = { $role }

label-rows = rows

# $n = 70
# $of = 1200
# $rest = "points.csv"
label-rows_chosen = { $n } of { $of } rows, evenly chosen; all are in { $rest }.

# $n = 300
# $of = 1200
label-rows_shown = { $n } of { $of } rows are shown.

# $n = 300
# $of = 1200
# $rest = "points.csv"
label-rows_shown_of = { $n } of { $of } rows are shown; all are in { $rest }.

label-setting = setting

label-share = share

label-sigma = sigma

# $symbol = "X"
label-sigma_of = sigma { $symbol }

label-sigma_ratio = σ a posteriori / a priori

label-smallest = smallest

label-source = source

label-standard_deviation = standard deviation

label-stated_sigma = stated sigma

label-status = status

label-symbol = symbol

label-test = test

label-time = time

label-to = to

# $value = true
label-truth = { $value ->
        [yes] yes
        *[no] no
    }

label-unit = unit

label-unknowns = unknowns

label-value = value

label-version = version

label-yes = yes

label-rms = rms

# $of = "x"
label-rms_of = rms { $of }
