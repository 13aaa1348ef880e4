# $first = "a"
# $second = "b"
report_compare-title = { $first } and { $second }

# $first = "a/result"
# $second = "b/result"
report_compare-subtitle = Comparison of two adjustments. First: { $first }; second: { $second }.

report_compare-summary = Side by side

report_compare-interior = Interior orientation

report_compare-points = Object points

report_compare-images = Images

report_compare-warnings = Warnings

# $first = 1.02
# $second = 0.98
report_compare-sigma0 = σ₀ { NUM($first) } and { NUM($second) }.

# $ratio = 2.4
# $part = false
report_compare-interior_ratio = Interior orientations differ by up to { NUM($ratio, digits: 2) } { $part ->
        [yes] standard deviations of a difference
        *[no] combined standard deviations
    }.

# $n = 29
# $rms = 0.4
# $unit = "mm"
# $fitted = true
report_compare-points_differ = { $n } common { $n ->
        [one] point differs
        *[other] points differ
    } by { NUM($rms, digits: 2) } { $unit } rms { $fitted ->
        [yes] after a similarity transformation
        *[no] without transformation
    }.

# $n = 8
report_compare-small_redundancy = The redundancy of the transformation is only { $n }.

report_compare-no_same_point = No object point is known to be the same in both.

# $name = "sigma0"
report_compare-quantity = { $name ->
        [sigma0] σ₀ a posteriori
        [redundancy] redundancy
        [observations] observations
        [unknowns] unknowns
        [constraints] datum constraints
        [image_points] image observations given
        [rejected] image observations rejected
        [images_count] images given
        [points_count] object points given
        [relative_precision] relative precision 1 : N
        [iterations] iterations
        [seconds] seconds
        [datum] datum
        *[raybundle] raybundle
    }

# $name = "reject"
report_compare-setting = setting { $name }

report_compare-first = first

report_compare-second = second

report_compare-both = both

report_compare-difference = second − first

# $names = ["A"]
report_compare-cameras_of_one = In one of the two only: { LIST($names, most: 12) }.

report_compare-no_common_camera = The two results have no camera in common.

# $part = false
report_compare-in_sigmas = in { $part ->
        [yes] its sigmas
        *[no] combined sigmas
    }

report_compare-correlated = Parameters of one camera are correlated: differences of some sigmas may cancel in the image.

# $n = 29
report_compare-common_points = { $n } { $n ->
        [one] point
        *[other] points
    } in common.

# $n = 40
report_compare-common_images = { $n } { $n ->
        [one] image
        *[other] images
    } in common.

# $which = "first"
# $names = ["P1"]
report_compare-only_in = Only in the { $which ->
        [first] first
        *[second] second
    }: { LIST($names, most: 20) }.

# $n = 4
# $names = ["t1"]
report_compare-namesakes = { $n } { $n ->
        [one] point
        *[other] points
    } with the same automatic name differ and are not compared: { LIST($names, most: 3) }.
    .why = Automatic names are running numbers; the image points lie elsewhere.

report_compare-free_datum = Compare results with a datum of their own (free networks) only after the transformation.

report_compare-too_few_points = There are too few common points for a similarity transformation.

# $fitted = true
report_compare-transformed = { $fitted ->
        [yes] After a similarity transformation of the second onto the first
        *[no] Without transformation
    }

# $larger = true
# $scale = 2.1e-5
# $rotation_deg = 0.012
# $translation = [0.1, 0.2, 0.3]
# $unit = "m"
report_compare-transformation = Scale 1 { $larger ->
        [yes] +
        *[no] −
    } { NUM($scale) }, rotation { NUM($rotation_deg) }°, translation ({ $translation }) { $unit }.

report_compare-rms_ratio = rms of d / sigma

report_compare-largest_differences = The largest differences

# $part = false
# $axis = "X"
report_compare-sigma_of = { $part ->
        [yes] sigma
        *[no] combined sigma
    } { $axis }

# $rms = 1.2
# $unit = "mm"
# $rotation_deg = 0.002
# $by = "points"
report_compare-centres = Projection centres differ by { NUM($rms) } { $unit } rms, rotations by { NUM($rotation_deg) }°.
    .why = { $by ->
            [points] In the system of the first, after the transformation of the points.
            [centres] In the system of the first, after the transformation of the projection centres.
            *[none] Without transformation.
        }

# $rms = 1.1
# $unit = "mm"
report_compare-own_transformation = After a transformation of their own, projection centres differ by { NUM($rms) } { $unit } rms.

report_compare-projection_centre = projection centre

report_compare-rotation = rotation

report_compare-all_images = All images, the largest difference first

report_compare-no_warning = Neither result has a warning.

report_compare-severity = severity

report_compare-code = code

report_compare-message = message

# $part = false
report_compare-sigma_meaning = { $part ->
        [yes] Sigma: root of the difference of both variances.
        *[no] Combined: root of the sum of both variances, as for independent results.
    }

report_compare-same = The two results are identical to the last bit.

# $n = 900
# $used_first = 1000
# $used_second = 920
# $part = "second"
report_compare-part_of_other = The results share { $n } of { $used_first } and { $used_second } image observations.
    .why = The observations of the { $part ->
            [first] first
            *[second] second
        } are part of the other; differences are compared with the root of the difference of both variances.

# $n = 900
# $used_first = 1000
# $used_second = 920
report_compare-not_independent = The results share { $n } of { $used_first } and { $used_second } image observations and are not independent.
    .why = Combined standard deviations are too large; real differences may not stand out.

# $same = false
# $first = "white"
# $second = "fields"
report_compare-noise_models = The noise model is { $same ->
        [yes] { $first } in both
        *[no] { $first } in the first and { $second } in the second
    }.

# $first = 1.0
# $second = 1.5
report_compare-noise_ratios = For that reason, standard deviations of points are { NUM($first) } and { NUM($second) } times those of white noise.

# $n = 29
# $centres = false
# $coordinates = 87
# $redundancy = 80
report_compare-basis = The transformation rests on { $n } common { $centres ->
        [yes] projection { $n ->
            [one] centre
            *[other] centres
        }
        *[no] { $n ->
            [one] point
            *[other] points
        }
    }: { $coordinates } coordinates, redundancy { $redundancy }.

# $uncertainty_percent = 25.0
# $absorbed_percent = 47.0
report_compare-small_basis = Caution: the rms of the differences is uncertain by { NUM($uncertainty_percent, digits: 2) } %.
    .why = The transformation absorbs { NUM($absorbed_percent, digits: 2) } % of their square sum on average.

report_compare-no_common_observation = No image observation is common to both.

# $n = 1000
# $first = 0
# $second = 3
report_compare-rejected_otherwise = Of { $n } common image { $n ->
        [one] observation
        *[other] observations
    }, { $first } are rejected only in the first, { $second } only in the second.

# $n = 1000
report_compare-rejected_alike = The same of { $n } common image { $n ->
        [one] observation
        *[other] observations
    } take part in both.

# $which = "first"
# $names = ["P1 (A)"]
report_compare-free_in = Free in the { $which ->
        [first] first
        *[second] second
    } only: { LIST($names, most: 12) }.

report_compare-free_alike = The same parameters of cameras are free.
