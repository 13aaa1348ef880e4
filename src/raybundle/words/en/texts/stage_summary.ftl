# $sigma0 = 1.02
stage_summary-adjustment = sigma0 { NUM($sigma0, decimals: 3) }.

# $pairs = 120
# $skipped = 15
# $verified = 98
stage_summary-matching = { $pairs } { $pairs ->
        [one] pair
        *[other] pairs
    }, { $skipped } unlike at first look, { $verified } verified.

# $pairs = 120
# $of = 4950
# $likely = 80
# $common = 30
# $between = 10
# $skipped = 15
# $verified = 98
stage_summary-matching_rounds = { $pairs } of { $of } pairs: { $likely } likely, { $common } with common neighbours, { $between } between parts; { $skipped } unlike, { $verified } verified.

# $n = 40
# $refused = 2
stage_summary-photographs = { $n } { $n ->
        [one] photograph
        *[other] photographs
    }, { $refused } refused.

# $n = 3
# $refused = 0
stage_summary-scenes = { $n } { $n ->
        [one] scene
        *[other] scenes
    }, { $refused } refused.

# $n = 9000
# $of = 12000
# $added = 1400
# $used = 9800
stage_summary-precision = { $n } of { $of } features measured again, { $added } rays added, { $used } used.

# $n = 3
# $verified = 3
stage_summary-scene_pairs = { $n } { $n ->
        [one] pair
        *[other] pairs
    } of scenes, { $verified } verified.

# $n = 800
stage_summary-scene_points = { $n } { $n ->
        [one] point
        *[other] points
    } of scenes.

# $n = 40
# $of = 42
# $parts = 1
# $points = 9800
stage_summary-start = { $n } of { $of } photographs{ $parts ->
        [1] {""}
        *[other] {" "}in { $parts } parts
    }, { $points } points.

# $n = 120
stage_summary-targets = { $n } { $n ->
        [one] target
        *[other] targets
    } read.

# $names = ["a.jpg"]
# $n = 1
stage_summary-by_features = { $names } { $n ->
        [one] uses
        *[other] use
    } positions and standard deviations of features.
    .why = Least-squares matching measures too few points there (a soft or very different photograph).

# $n = 90
# $of = 120
# $added = 14
stage_summary-scene_precision = { $n } of { $of } in scenes, { $added } rays added.

# $pairs = 12
# $verified = 6
# $joined = 3
# $cpu_s = 24
# $budget_s = 60
stage_summary-wide_baselines = { $pairs } { $pairs ->
        [one] further pair
        *[other] further pairs
    }, { $verified } verified, { $joined } { $joined ->
        [one] photograph
        *[other] photographs
    } joined; CPU budget { NUM($cpu_s, decimals: 0) } of { NUM($budget_s, decimals: 0) } s.
