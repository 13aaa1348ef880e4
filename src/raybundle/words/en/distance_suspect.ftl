# $name = "M1-M2"
# $length = 1.0003
# $shown = 1.0123
# $unit = "m"
# $w = 6.1
# $limit = 4.2
# $before = 3.4
# $after = 1.1
# $ids = ["M1-M2"]
distance_suspect-control = Scale bar { $name } contradicts the control: { NUM($length, digits: 6) } { $unit } given, { NUM($shown, digits: 6) } { $unit } measured.
    .why = |w| is { NUM($w, decimals: 1) } (limit { NUM($limit, decimals: 1) }); without this bar residuals of control and bars fall from { NUM($before, digits: 2) } to { NUM($after, digits: 2) } times the stated size.
    .do = Check its length and the names of its ends, before any control.

# $kind = "distances"
# $name = "M1-M2"
# $component = ""
# $given = 1.0003
# $off = 0.5
# $sigma = 0.0001
# $unit = "m"
# $w = 61.0
# $limit = 4.2
# $share = 0.1
# $ids = ["M1-M2"]
distance_suspect-far = Scale bar { $name } contradicts the other observations by more than { PERCENT($share) } % of its length.
    .why = Given: { NUM($given, digits: 12) } { $unit } (sigma { $sigma } { $unit }, |w| { NUM($w, decimals: 1) }, limit { NUM($limit, decimals: 1) }).
    .do = Check its length, unit and end points.

# $bars = 2
# $given = 1.0
# $shown = 0.5
# $ids = ["A-B", "C-D"]
distance_suspect-contradict = { $bars } scale bars contradict each other: { LIST($ids, most: 5) }.
    .why = Without them the block fits; which one is wrong is ambiguous.
    .do = Check their lengths, units and end points, or measure a further length.

# $name = "A-B"
# $given = 1.0
# $unit = "m"
# $factor = 1000.0
distance_suspect-factor = { $name } ({ NUM($given, digits: 6) } { $unit }): relative factor { NUM($factor, digits: 5) }

# $bars = 1
# $given = 1000.0
# $shown = 1.0
# $likely = "mm"
# $ids = ["A-B"]
distance_suspect-left_out = { $bars } scale { $bars ->
     [one] bar contradicts
     *[other] bars contradict
    } all other observations and { $bars ->
     [one] is
     *[other] are
    } left out: { LIST($ids, most: 5) }.
    .do = { $likely ->
     [none] Check length, unit and end points
     *[other] Check length, unit (probably { $likely }) and end points
    }.

# $name = "A-B"
# $given = 1000.0
# $shown = 1.0
# $unit = "m"
distance_suspect-bar = Scale bar { $name }: { NUM($given, digits: 6) } { $unit } given, { NUM($shown, digits: 6) } { $unit } in the block.

# $start = "A"
# $end = "B"
# $given_m = 1000.0
# $measured_m = 1.001
# $ratio = 999.0
# $limit = 1.5
# $of = "bar"
# $likely = "mm"
# $ids = ["A", "B"]
distance_suspect-beside_control = Scale bar { $start } - { $end } contradicts the control and is left out: factor { NUM($ratio, digits: 4) } (limit { $limit }).
    .why = Given are { NUM($given_m, digits: 6) } m; in the system of the control it is { NUM($measured_m, digits: 4) } m.
    .do = { $of ->
     [bar] Give its length in metres; it is probably in { $likely }
     [control] Give the control in metres; it is probably in { $likely }
     *[none] Check its length and end points, and the unit of the control
    }.
