# $epochs = ["2019", "2021"]
report_moved-title = Displacements: { LIST($epochs, most: 20) }

report_moved-subtitle = Congruence test over common points, in the datum of the stable points

# $names = ["A", "B"]
# $n = 2
# $of = 40
# $significance = 0.05
report_moved-moved = { $n } of { $of } common points moved: { LIST($names, most: 8) } (significance { PERCENT($significance) } %).

# $of = 40
# $significance = 0.05
report_moved-none_moved = None of { $of } common points moved (significance { PERCENT($significance) } %).

report_moved-contradiction = The measurements contradict each other; see below.

# $f = 4.2
# $p = 0.001
# $factor = 2.05
report_moved-inconsistent = Stable points differ more than their standard deviations allow (F { NUM($f) }, { P($p) }).
    .why = Standard deviations { NUM($factor) } times as large would explain it.

# $names = ["2021"]
report_moved-faulty = Do not use yet, by the own report of { $names }; see below.

report_moved-points_moved = points that moved

# $n = 40
report_moved-of_points = of { $n }

report_moved-largest = largest displacement

# $name = "A"
report_moved-at_point = point { $name }

report_moved-detectable = detectable from

# $power = 0.8
# $worst = 1.2
# $unit = "mm"
report_moved-power = with a probability of { PERCENT($power) } %, median; { NUM($worst, digits: 2) } { $unit } at the worst point

report_moved-measurements = Measurements

report_moved-axes = Axes

# $name = "2019"
report_moved-axes_of = those of { $name }

# $name = "axes.csv"
# $n = 5
# $rms_mm = 0.4
report_moved-axes_fitted = those of { $name }, fitted to { $n } { $n ->
        [one] point
        *[other] points
    } (rms { NUM($rms_mm, digits: 2) } mm)

report_moved-displacements = Displacements

report_moved-column_moved = moved

# $epoch = "2021"
# $first = "2019"
report_moved-difference = { $epoch } minus { $first }

report_moved-p_meaning = p: probability of a larger displacement by measurement errors alone, for this point alone.

report_moved-tests = Tests

report_moved-global_test = global test

report_moved-all_points = all points, under the hypothesis of no movement

report_moved-stable_points = stable points

# $limit = 0.001
report_moved-limit = A point counts as moved where its probability is below { NUM($limit, digits: 2) }.
    .why = This is the significance divided by the number of points.

# $known = true
# $n = 1200
report_moved-freedom = The variance factor has { $known ->
        [yes] { NUM($n) } degrees of freedom
        *[no] no uncertainty
    }.

# $free = false
report_moved-scale = { $free ->
        [yes] Epochs may differ in scale: lengths are those of the first.
        *[no] Each epoch has its own measured scale.
    }

report_moved-limits = Not detectable: a motion common to all points, and one below the level of detection.

report_moved-untested = untested

report_moved-untested_why = displaced, but a wrong image point explains it as well

# $n = 300
report_moved-of_joint = of { $n } that are tested jointly
