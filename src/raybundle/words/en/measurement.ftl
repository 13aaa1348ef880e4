# $name = "bench"
# $points = ["A7"]
measurement-unknown_points = { $name } has no point { $points }.
    .do = Correct the point names.

# $name = "bench"
# $n = 5
# $xyz = [4, 3]
# $covariance = [15, 15]
measurement-shapes = { $name }: { $n } names, coordinates of shape ({ $xyz }), covariance of shape ({ $covariance }).
    .do = Give (n, 3) coordinates and a (3n, 3n) covariance matrix.

# $name = "bench"
# $point = "A1"
measurement-point_twice = { $name } contains point { $point } twice.
    .do = Delete or rename one of them.

# $points = 73
# $images = 38
# $of = 39
measurement-points = Measured: { $points } { $points ->
        [one] point
        *[other] points
    } in { $images } of { $of } photographs.

# $rms = 0.012
# $largest = 0.04
# $point = "17"
# $free_scale = false
measurement-precision = Standard deviation of a coordinate: { NUM($rms, digits: 2) } { $free_scale ->
        [yes] thousandths, scale arbitrary
        *[no] mm
    } (rms), { NUM($largest, digits: 2) } largest (point { $point }).

# $n = 12
# $rms_mm = 0.02
# $largest_mm = 0.09
# $point = "17"
# $significant = 2
# $of = 73
measurement-fit = Deviations from nominal: { NUM($rms_mm, digits: 2) } mm (rms), largest { NUM($largest_mm, digits: 2) } mm ({ $point }); { $significant } of { $of } significant.

# $within = 70
# $beyond = 1
# $names = ["12"]
# $undecided = 2
measurement-tolerances = Tolerances (ISO 14253-1): { $within } met, { $beyond } exceeded{ $beyond ->
        [0] {""}
        *[other] {" "}({ $names })
    }, { $undecided } undecided.

# $scale = 1.00001
# $sigma = 0.000002
measurement-scale = Scale of the fit: { NUM($scale, decimals: 7) } ± { NUM($sigma, digits: 1) }.

# $n = 40
# $rms_mm = 0.01
# $largest_mm = 0.03
# $start = "2"
# $end = "74"
# $judged = "met"
# $over = 0
measurement-lengths = { $n } known { $n ->
        [one] length
        *[other] lengths
    }: error { NUM($rms_mm, digits: 2) } mm (rms), largest { NUM($largest_mm, digits: 2) } mm ({ $start } - { $end }){ $judged ->
        [met] ; limits met
        *[none] {""}
        [exceeded] ; { $over } beyond the limit
    }.

# $within = 0.97
# $F = 0.9
# $p = 0.6
measurement-length_test = { PERCENT($within) } % of the errors are within two standard deviations; test of all F = { $F } ({ P($p) }).

# $n = 1
# $independent = true
measurement-lengths_served = { $independent ->
        [yes] { $n } of the lengths served as scale bars.
        *[no] All lengths served as scale bars: they are no test.
    }
