# $n = 1
# $limit_deg = 5.0
# $ids = ["east"]
line_alone = { $n } { $n ->
        [one] trajectory has
       *[other] trajectories have
     } lines of one viewing direction only: { $ids }.
    .why = Corrections of position and attitude are weakly separated from each other and from the points; control and stated standard deviations carry them.
    .do = Add lines that look ahead or back by more than { $limit_deg }°, crossing strips, or control.
