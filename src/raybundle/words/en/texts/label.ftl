# $n = 300
# $of = 1200
label-rows_shown = { $n } of { $of } rows are shown.

# $n = 300
# $of = 1200
# $rest = "points.csv"
label-rows_shown_of = { $n } of { $of } rows are shown; all are in { $rest }.

label-quantity = quantity

label-value = value

label-camera = camera

label-symbol = symbol

label-unit = unit

label-sigma = sigma

label-ratio = ratio

# $n = 70
# $of = 1200
# $rest = "points.csv"
label-rows_chosen = { $n } of { $of } rows, evenly chosen; all are in { $rest }.

label-image = image

label-point = point

label-axis = axis

label-rays = rays

label-reason = reason

label-largest_w = largest |w|

label-test = test

label-level = level

label-source = source

label-mdb_note = MDB: minimal detectable bias.

label-file = file

label-points = points

label-rejected = rejected

label-sigma_ratio = σ a posteriori / a priori

label-coordinate = coordinate

label-mean = mean

label-smallest = smallest

label-median = median

label-largest = largest

label-at_point = at point

label-intersection_angle = intersection angle

# $symbol = "X"
label-sigma_of = sigma { $symbol }

label-figure = figure

label-meaning = meaning

label-common_points = common points

label-status = status

label-share = share

label-given = given

label-adjusted = adjusted

label-residual = residual

label-held = held

label-observations = observations

label-group = group

label-number = number

label-redundancy = redundancy

# $n = 38
# $of = 40
label-n_of = { $n } of { $of }

label-cameras = cameras

label-object_points = object points

label-image_points = image points

label-photograph = photograph

label-photographs = photographs

label-remedy = remedy

label-pairs = pairs

label-name = name

label-time = time

label-result = result

label-setting = setting

label-observed = observed

label-stated_sigma = stated sigma

label-model = model

label-parameter = parameter

# $n = 12
label-count_of_points = { $n } { $n ->
        [one] point
        *[other] points
    }

label-length = length

label-yes = yes

label-from = from

label-to = to

label-measured = measured

label-error = error

label-allowed = allowed

label-role = role

# $role = "tie"
label-role_of = { $role }

label-angle = angle

label-rows = rows

label-version = version
