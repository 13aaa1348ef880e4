report_metrology-deviations = Deviations from nominal coordinates

# $n = 2
# $names = ["7", "12"]
report_metrology-not_measured = { $n } nominal { $n ->
        [one] point
        *[other] points
    } not measured: { LIST($names, most: 8) }.

# $weights = true
# $estimated = false
# $scale = 1.0000021
# $sigma_ppm = 3.1
report_metrology-fit = { $weights ->
        [yes] weighted by their joint covariance
        *[no] equal weights
    }; scale { $estimated ->
        [yes] { NUM($scale, digits: 8) } ± { NUM($sigma_ppm, digits: 2) } ppm
        *[no] unchanged
    }

report_metrology-axes = axes fitted to

report_metrology-coordinate_deviation = deviation of a coordinate

report_metrology-coordinate_deviation_meaning = rms of the points used for the axes

report_metrology-largest_deviation = largest deviation

# $name = "12"
report_metrology-point = point { $name }

report_metrology-significant = significant deviations

# $n = 26
report_metrology-significant_meaning = of { $n } { $n ->
        [one] point
        *[other] points
    }, all tests together

report_metrology-tolerances = tolerances

# $n = 20
report_metrology-within = { $n } within

# $n = 2
# $undecided = 1
report_metrology-beyond = { $n } beyond, { $undecided } undecided (ISO 14253-1, two standard deviations)

report_metrology-fitted = fitted

report_metrology-tolerance = tolerance

report_metrology-verdict = verdict

# $verdict = "within"
report_metrology-verdict_of = { $verdict }

report_metrology-d_note = d: measured minus nominal, in nominal axes; sigma includes errors of the fit.

report_metrology-p_note = p: probability of a larger deviation by errors of measurement alone.

report_metrology-marked = Marked: significant, all tests together.

report_metrology-lengths = Errors of known lengths

# $n = 6
report_metrology-length_errors = Errors of { $n } { $n ->
        [one] length
        *[other] lengths
    } with two standard deviations.

report_metrology-dashed = Dashed: limits.

report_metrology-guideline = Errors as in VDI/VDE 2634 part 1, compared with A + K L if that is stated.

report_metrology-no_acceptance_test = This is no acceptance test: number and directions of the lines in the volume are not checked.
    .why = Lengths that served as scale bars are no test.

report_metrology-largest_error = largest error

report_metrology-length_error = error of a length

report_metrology-stated_deviation = stated standard deviation

report_metrology-stated_deviation_meaning = rms, including that of the known lengths

report_metrology-within_two = within two standard deviations

# $f = 1.3
# $p = 0.24
report_metrology-within_two_meaning = 95 % expected; all together F { $f }, { P($p) }

report_metrology-allowed_errors = allowed errors

# $kept = true
report_metrology-kept = { $kept ->
        [yes] met
        *[no] exceeded
    }

# $n = 0
report_metrology-over = { $n } beyond
