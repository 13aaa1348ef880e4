# $name = "asprs"
outcome-name = { $name ->
        [accuracy] Required accuracy
        [asprs] ASPRS accuracy class
        [tolerances] Tolerances
        [displacements] Displacements
        [limit] Limit of displacements
        *[lengths] Lengths
    }

# $name = "asprs"
outcome-not_kept = Not kept: { $name ->
        [accuracy] required accuracy
        [asprs] ASPRS accuracy class
        [tolerances] tolerances
        [limit] limit of displacements
        *[lengths] permissible errors of lengths
    }.

# $over = 2
# $n = 6
outcome-lengths = { $over ->
        [0] All { $n } errors are within the permissible limits.
        *[other] { $over } of { $n } errors exceed the permissible limits.
    }

# $within = 20
# $beyond = 1
# $undecided = 2
outcome-tolerances = { $within } within, { $beyond } beyond, { $undecided } undecided (at two standard deviations).

# $point = "t12"
# $deviation_mm = 0.42
# $tolerance_mm = 0.3
outcome-beyond = { $point }: { NUM($deviation_mm, digits: 2) } mm, tolerance { NUM($tolerance_mm, digits: 6) } mm.

# $n = 3
outcome-more_beyond = { $n } more beyond.

# $n = 6
# $independent = true
# $largest_mm = 0.42
# $start = "M1"
# $end = "M2"
# $rms_mm = 0.21
outcome-length_errors = { $n } { $independent ->
        [yes] independent
        *[no] adjusted
    } { $n ->
        [one] length
        *[other] lengths
    }: largest error { NUM($largest_mm, digits: 2) } mm ({ $start } – { $end }), rms { NUM($rms_mm, digits: 2) } mm{ $independent ->
        [yes] .
        *[no] ; scale bars, no test.
    }

# $within = 0.95
# $f = 1.2
# $p = 0.3
# $contradicts = false
outcome-length_test = { PERCENT($within) } % within two standard deviations; F { NUM($f) } ({ P($p) }): { $contradicts ->
        [yes] standard deviations are too small
        *[no] consistent
    }.

# $kept = true
outcome-kept = { $kept ->
        [yes] Kept.
        *[no] Not kept.
    }

# $wanted = 5
# $wanted_unit = "mm"
outcome-no_heights = Height: { NUM($wanted, digits: 4) } { $wanted_unit } required, not judged: no height was given, heights are relative.

# $part = "horizontal"
# $wanted = 5
# $wanted_unit = "mm"
# $median = 8
# $median_unit = "mm"
outcome-not_precise = { $part ->
        [horizontal] Plan
        *[vertical] Height
    }: { NUM($wanted, digits: 4) } { $wanted_unit } required, not kept: median standard deviation { NUM($median) } { $median_unit }.

# $part = "horizontal"
# $wanted = 5
# $wanted_unit = "mm"
# $rms = 8
# $rms_unit = "mm"
outcome-only_control = { $part ->
        [horizontal] Plan
        *[vertical] Height
    }: { NUM($wanted, digits: 4) } { $wanted_unit } required, not judged: no check points.
    .why = Leave-one-out of control: { NUM($rms) } { $rms_unit } rms.

# $part = "horizontal"
# $wanted = 5
# $wanted_unit = "mm"
outcome-no_check_points = { $part ->
        [horizontal] Plan
        *[vertical] Height
    }: { NUM($wanted, digits: 4) } { $wanted_unit } required, not judged: no check points.

# $part = "horizontal"
# $found = 3.2
# $found_unit = "mm"
# $n = 40
# $wanted = 5
# $wanted_unit = "mm"
# $needed = 30
# $verdict = "kept"
outcome-accuracy = { $part ->
        [horizontal] Plan: RMSE_H
        *[vertical] Height: RMSE_V
    } { NUM($found) } { $found_unit } at { $n } check { $n ->
        [one] point
        *[other] points
    }, { NUM($wanted, digits: 4) } { $wanted_unit } required: { $verdict ->
        [kept] kept.
        [lost] not kept.
        [few] not judged (fewer than { $needed } check points).
        *[other] no tested ASPRS statement.
    }
    .why = { $verdict ->
            [unsurveyed] The standard requires standard deviations of the check points.
            [untested] The standard requires { $needed } check points.
            *[other] {""}
        }

outcome-see_report = Not kept, see the report of the result.
