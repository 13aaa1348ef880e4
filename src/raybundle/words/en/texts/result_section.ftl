result_section-title = Result

result_section-summary = Summary of the adjustment

result_section-warnings = Warnings and remedies

result_section-limits = Limits of these figures

result_section-message = message and remedy

result_section-severities = Fault: settle before use. Warning: part of the result is weaker than it looks.
    .why = Note: what was done or chosen.

# $median = 0.3
# $unit = "mm"
result_section-median = Median { NUM($median, digits: 2) } { $unit }.

# $n = 4
result_section-check_rms = rms difference of a coordinate, { $n } { $n ->
        [one] point
        *[other] points
    }

result_section-sigma0 = σ₀ a posteriori

# $px = 0.06
# $median = false
result_section-image_sigma = a priori 1; an image coordinate { NUM($px, digits: 2) } px{ $median ->
        [yes] {" "}(median)
        *[no] {""}
    }

result_section-no_image_observations = a priori 1; no image observations

# $n = 1530
result_section-observations = { $n } observations

# $used = 7
# $given = 8
# $rejected = 0
result_section-used = { $used } used, { $given } given{ $rejected ->
        [0] {""}
        *[other] , { $rejected } rejected
    }

# $kind = "control"
result_section-quantities = { $kind ->
        [control] control coordinates
        [distance] scale bars
        [station] coordinates of projection centres
        [attitude] angles of attitudes
        [coordinate] coordinates of networks
        [deviation] deviations of single images
        [parameter] observed parameters
        [relation] relations of parameters
        [direction] directions
        [zenith_angle] zenith angles
        [slope_distance] slope distances
        [difference] coordinate differences
        [plane] distances of points from planes
        [line] distances of points from lines
        [plumb_line] distances of points from plumb lines
        [level] heights of points above levels
        *[other] { $kind }
    }

# $n = 12
# $held = 3
result_section-observed = { $n } observed{ $held ->
        [0] {""}
        *[other] , { $held } held
    }

result_section-constraints = datum constraints

result_section-not_fixed = not fixed by observations

# $which = "other"
# $parts = ["tX", "rZ"]
result_section-open_parts = { $which ->
        [nothing] nothing
        [position_orientation_scale] position, orientation, scale
        [position_orientation] position, orientation
        [position_scale] position, scale
        [orientation_scale] orientation, scale
        [position] position
        [orientation] orientation
        [scale] scale
        [line] rotation about a straight line
        *[other] { LIST($parts, most: 7) } (t position, r rotation, m scale)
    }

result_section-residuals = residuals refer to

# $corrected = true
result_section-refer_to = the { $corrected ->
        [yes] corrected
        *[no] measured
    } image point

result_section-convergence = converged

# $converged = true
# $n = 5
# $seconds = 1.2
result_section-converged = { $converged ->
        [yes] yes
        *[no] no
    }, { $n } { $n ->
        [one] iteration
        *[other] iterations
    }, { NUM($seconds, decimals: 2) } s

result_section-condition = condition of the scaled normal matrix (approximate, from its smallest pivot)

result_section-untestable = not possible without redundancy

# $lower = 94179.2
# $upper = 95888.1
# $verdict = "passed"
result_section-tested = { NUM($lower, digits: 5) } … { NUM($upper, digits: 5) }: { $verdict ->
        [passed] passed
        [larger] failed, residuals larger than assumed
        *[smaller] failed, residuals smaller than assumed
    }

result_section-sigma0_both = σ₀ a priori, a posteriori

result_section-square_sum = weighted square sum of residuals

result_section-global_test = global test (χ², 95 %, two-sided)

# $statistic = "w"
result_section-critical = critical value of { $statistic ->
        [w] |w|
        *[tau] |τ|
    }, family-wise

# $critical = 4.1
# $level = 0.05
result_section-at_level = { NUM($critical) } at { PERCENT($level) } %
