report_accuracy-title = Accuracy: basis of each figure

report_accuracy-object_note = Standard deviations contain random errors, differences at check points all errors.

report_accuracy-all_points = Object points are everywhere those with a free coordinate and a used ray.

report_accuracy-in_object_space = In object space

report_accuracy-in_images = In the images

report_accuracy-image_note = Stated times σ₀ is the precision of a measurement; its residual is smaller by the share 1 − r.
    .why = The adjustment absorbs this share of each error (r: mean redundancy number).

report_accuracy-over = basis

report_accuracy-noise_column = noise

# $noise = "white"
report_accuracy-noise = { $noise ->
        [white] independent errors
        [fields] independent and smooth errors
        *[none] none: differences
    }

# $kind = "object"
# $n = 231
# $coordinates = 693
report_accuracy-points = { $n } { $kind ->
        [object] object
        [check] check
        *[control] control
    } { $n ->
        [one] point
        *[other] points
    }, { $coordinates } { $coordinates ->
        [one] coordinate
        *[other] coordinates
    }

# $n = 30
report_accuracy-check_points = { $n } check { $n ->
        [one] point
        *[other] points
    }

# $n = 6
report_accuracy-lengths = { $n } { $n ->
        [one] length
        *[other] lengths
    }

# $n = 1530
# $coordinates = 3060
report_accuracy-image_observations = { $n } used image { $n ->
        [one] observation
        *[other] observations
    }, { $coordinates } coordinates

# $kind = "rms"
report_accuracy-deviation = standard deviation, { $kind ->
        [rms] rms
        [mean] mean
        *[median] median
    }

report_accuracy-deviation_rms = of a coordinate; enlarged by a few weak points

# $omitted = 0.05
# $related = true
report_accuracy-deviation_mean = of a coordinate{ $omitted ->
        [0] {""}
        *[other] , without the { PERCENT($omitted) } % least precise points
    }{ $related ->
        [yes] ; that of 1 : N
        *[no] {""}
    }

report_accuracy-deviation_median = half of the coordinates are more precise

report_accuracy-relative = relative precision

# $extent = 12.8
# $unit = "m"
# $cut = true
report_accuracy-relative_meaning = mean standard deviation over the largest extent, { $extent } { $unit }
    .why = Extent: diagonal of the box along the principal axes{ $cut ->
            [yes] , without the outermost 0.25 % at either end of an axis
            *[no] {""}
        }

report_accuracy-check = difference at check points, rms

report_accuracy-check_meaning = adjusted minus given; contains errors of the given coordinates and those common to all photographs

report_accuracy-expected = expected

report_accuracy-check_expected = standard deviation of adjusted and given coordinate together, at these points

report_accuracy-length_error = error of known lengths, rms

report_accuracy-length_meaning = measured minus known, of independent lengths; contains the errors of their certificates

report_accuracy-length_expected = standard deviation of measured and known length together

# $plan = true
report_accuracy-asprs = { $plan ->
        [yes] both axes of the plan together
        *[no] height
    }: difference at check points, with their stated error

report_accuracy-points_left_out = leave-one-out, control points, rms

report_accuracy-points_meaning = adjusted minus given if the whole point had taken no part, to first order

report_accuracy-coordinates_left_out = leave-one-out, control coordinates, rms

report_accuracy-coordinates_meaning = the same for one coordinate at a time, with the others of its point

report_accuracy-image_coordinate = image coordinate

report_accuracy-no_image_point = no image point

report_accuracy-not_measured = no measurement in images

# $kind = "median"
report_accuracy-stated = stated{ $kind ->
        [one] {""}
        [median] , median
        *[rms] , rms
    }

report_accuracy-stated_meaning = a-priori standard deviation of each observation (its weight)

report_accuracy-stated_rms = less precise points count more

# $kind = "median"
report_accuracy-scaled = stated times σ₀{ $kind ->
        [one] {""}
        [median] , median
        *[rms] , rms
    }

# $sigma0 = 1.02
# $kind = "rms"
report_accuracy-by_sigma0 = from the residuals: σ₀ = { $sigma0 }{ $kind ->
        [rms] ; that of a measured image point
        *[median] {""}
    }

report_accuracy-residual = residual, rms

# $known = true
# $r = 0.62
report_accuracy-residual_meaning = adjusted minus measured{ $known ->
        [yes] , mean redundancy number { NUM($r, digits: 2) }
        *[no] {""}
    }
