# $factor = 1000.2
# $std = 0.0004
# $of = "bars"
# $likely = "mm"
# $unit = "m"
approximate_scale = The scale bars make the block { NUM($factor, digits: 5) } times as large as the approximate values (± { NUM($std, digits: 2) } relative).
    .why = No other observation fixes the scale.
    .do = { $of ->
     [bars] Check whether the lengths of the scale bars are in { $likely }, not { $unit }
     *[start] Check whether the approximate values are in { $likely }, not { $unit }
    }.
