heights-scale_free = The scale is free: lengths have no unit.

# $lines = 31
# $n = 6
# $low = 0.0
# $high = 0.1
# $unit = "m"
heights-contours = Contours: { $lines } { $lines ->
        [one] line
        *[other] lines
    } at { $n } { $n ->
        [one] height
        *[other] heights
    }, { NUM($low, digits: 6) } to { NUM($high, digits: 6) } { $unit }.

# $share = 0.023
heights-ground = Ground: { PERCENT($share) } % of the heights are on objects and were removed.

# $share = 0.12
# $sigma = 0.01
# $sigma_gaps = 0.04
# $unit = "m"
heights-gaps = Median sigma: { NUM($sigma, digits: 2) } { $unit } measured, { NUM($sigma_gaps, digits: 2) } { $unit } across gaps ({ PERCENT($share) } %).

# $name = "section 1"
# $length = "0.88 m"
heights-section_without_heights = { $name }: length { $length }, no heights.

# $name = "section 1"
# $length = "0.88 m"
# $mean = "0.0412 m (sigma 0.0012)"
heights-section = { $name }: length { $length }, mean height { $mean }.

# $name = "section 1"
# $share = 0.92
# $sigma = "0.5 mm"
heights-section_precision = { $name }: heights on { PERCENT($share, digits: 3) } %, sigma of a place { $sigma } (median).

# $name = "section 1"
# $share = 0.12
heights-section_filled = { $name }: { PERCENT($share, digits: 3) } % of the heights were filled, not measured.

# $name = "section 1"
# $difference = "0.023 m (sigma 0.001)"
heights-section_difference = { $name }: height difference { $difference }.

# $base = "0"
# $above = "0.00420 m3 (sigma 0.00021)"
# $below = "0.00002 m3 (sigma 0.00001)"
heights-volume = Volume above the base ({ $base ->
        [rim] plane along the outline
        *[other] { $base }
    }): { $above }; below: { $below }.

# $net = "0.00418 m3 (sigma 0.00021)"
heights-net_volume = Net volume: { $net }.

# $local = "0.00002"
# $orientation = "0.0002"
heights-volume_sigma = Sigma of the net volume: local errors { $local }, orientation { $orientation }.

# $mean = "0.0100 m (sigma 0.0005)"
heights-mean_height = Mean height above the base: { $mean }.

# $area = "0.42 m2"
# $true_area = "0.451 m2 (sigma 0.002)"
heights-area = Area in plan: { $area }; true area: { $true_area }.

# $share = 0.0038
# $sigma = "0.00001"
heights-volume_filled = { PERCENT($share, digits: 3) } % of the area was filled (adds sigma { $sigma } to the net volume).

# $n = 1
# $limit = 4.2
heights-moved = { $n ->
        [0] No region moved relative to the rest
        [one] 1 region moved relative to the rest
        *[other] { $n } regions moved relative to the rest
    } (limit { $limit } sigma, false-alarm rate 5 %).

# $amount = "0.0006"
# $side = 0.2
# $unit = "m"
# $all_places = true
heights-level_of_detection = Level of detection (80 % power): { $amount } { $unit } over { $side } x { $side } { $unit }{ $all_places ->
        [yes] {" "}(median)
        *[no] , in the best quarter only
    }.

heights-no_movement_detectable = Level of detection: not known (too few heights, or all at steps).

# $shift = "0.0002 m (sigma 0.001)"
# $chi2 = 1.2
# $limit = 7.81
# $significant = false
heights-whole = Movement of the whole: shift { $shift }, { $significant ->
        [yes] significant
        *[no] not significant
    } (chi2 { $chi2 }, limit { $limit }).

# $tilts = ["0.0002 (sigma 0.001)", "0.0001 (sigma 0.001)"]
heights-tilts = Tilts of the whole: { $tilts }.

# $share = 0.97
heights-compared = { PERCENT($share, digits: 3) } % of the heights before have one after.

# $share = 0.935
heights-same_measurement = { PERCENT($share, digits: 4) } % of the heights are one measurement in both: unmoved, not tested.

# $k = 1
# $mean = "0.0029 m (sigma 0.0004)"
# $area = "0.09 m2 (sigma 0.004)"
# $volume = "0.00026 m3 (sigma 0.00002)"
heights-region = Region { $k }: { $mean } over { $area }, volume { $volume }.

# $k = 1
# $amount = "0.0030 m (sigma 0.0004)"
# $peak = 12.3
# $times = 7.5
heights-region_inner = Region { $k }: inner part { $amount }, { $times } sigma; strongest window { $peak } sigma.

# $side = 0.2
# $amount = 0.0006
# $best = 0.0004
# $unit = "m"
# $median = true
heights-smallest = Smallest detectable movement over { $side } x { $side }: { $median ->
        [yes] { NUM($amount, digits: 2) } (median)
        *[no] not known (median)
    }, { NUM($best, digits: 2) } { $unit } (best quarter).

# $common = "known"
heights-one_adjustment = Both surfaces are of one adjustment. { $common ->
        [known] Common errors of the orientation cancel.
        *[unknown] Their orientations are taken as independent.
    }

heights-same_frame = Both surfaces need one frame: the same control, or common stable points.

# $name = "heights.tif"
heights-changed_values = { $name } has other values than were written.
    .why = The standard deviations are those of the values before.

# $name = "r"
heights-adjusted_since = { $name } was adjusted again after this surface was measured.
    .do = raybundle surface { $name }

# $n = 3
# $total = 6
# $significance = 0.05
heights-series = { $n } of { $total } volume changes are significant (false-alarm rate of all { PERCENT($significance) } %).

# $name = "pile A"
# $volume = "312.4 m3 (sigma 2.1)"
# $start = "2026-05-01"
# $change = "40.2 m3 (sigma 2.5)"
# $significant = true
# $parts = "none"
# $fill = "22.0"
# $cut = "1.9"
# $detectable = "8.4"
# $unit = "m"
heights-series_region = { $name }: { $volume }; since { $start } { $significant ->
        [yes] { $change }
        *[no] { $parts ->
            [none] no significant change
            [fill] no significant net change; fill { $fill } significant
            [cut] no significant net change; cut { $cut } significant
            *[both] no significant net change; fill { $fill }, cut { $cut } significant
        }
    }, detectable { $detectable }{ $unit ->
        [none] {""}
        *[other] {" "}{ $unit }3
    }.

# $name = "pile A"
# $start = "2026-05-01"
# $end = "2026-06-01"
# $change = "20.1 m3 (sigma 2.5)"
# $significant = true
# $parts = "none"
# $fill = "22.0"
# $cut = "1.9"
# $detectable = "8.4"
# $unit = "m"
heights-series_change = { $name }, { $start } to { $end }: { $significant ->
        [yes] { $change }
        *[no] { $parts ->
            [none] no significant change
            [fill] no significant net change; fill { $fill } significant
            [cut] no significant net change; cut { $cut } significant
            *[both] no significant net change; fill { $fill }, cut { $cut } significant
        }
    }, detectable { $detectable }{ $unit ->
        [none] {""}
        *[other] {" "}{ $unit }3
    }.

# $name = "pile A"
# $start = "2026-05-01"
# $end = "2026-06-01"
# $fill = "22.0 m3 (sigma 2.2)"
# $cut = "1.9 m3 (sigma 1.1)"
heights-series_parts = { $name }, { $start } to { $end }: fill { $fill }, cut { $cut }.

# $name = "pile A"
# $rate = "0.66 m3 (sigma 0.04)"
# $p = 0.31
heights-series_rate = { $name }: { $rate } a day on average; constant rate: { P($p) }.

# $common = "known"
heights-series_orientations = { $common ->
        [known] All dates are of one adjustment: their common errors count once.
        [unknown] All dates are of one adjustment, but their orientations are taken as independent.
        *[independent] Orientations of the dates are taken as independent; the same control makes changes more precise.
    }

# $share = 0.83
# $up = "0.11 m (sigma 0.02)"
heights-aligned = Other model aligned by { PERCENT($share) } % of the heights: height { $up }.

# $right = "0.31 m (sigma 0.02)"
# $above = "-0.18 m (sigma 0.02)"
heights-aligned_plan = Shift of the other model in plan: right { $right }, up { $above }.

# $tilts = ["0.0002 (sigma 0.001)", "0.0001 (sigma 0.001)"]
heights-aligned_tilts = Tilts of the other model: { $tilts }.

# $sigma = 0.05
# $common = 0.03
# $cells = 6.0
# $unit = "m"
heights-noise_estimated = Noise of the other model (estimated): { NUM($sigma, digits: 2) } { $unit }, of which { NUM($common, digits: 2) } { $unit } over { NUM($cells, digits: 2) } cells.
