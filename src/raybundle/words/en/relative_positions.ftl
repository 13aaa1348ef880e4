# $control = true
relative_positions = The positions agree with each other better than their standard deviations state.
    .why = { $control ->
     [yes] Their common offset is taken from the control.
     *[no] The stated standard deviations hold for their common offset, which no residual shows.
    }
    .do = { $control ->
     [yes] { "" }
     *[no] Give control points to determine this offset.
    }

# $direction = "plan"
# $sigma_m = 0.34
# $stated_m = 5.0
relative_positions-direction = { $direction ->
     [plan] In plan
     *[height] In height
    }: { NUM($sigma_m, digits: 2) } m, stated or assumed { NUM($stated_m, digits: 2) } m
