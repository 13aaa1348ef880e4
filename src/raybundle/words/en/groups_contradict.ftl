# $groups = 2
# $solved = true
# $sigma0 = 45.0
groups_contradict = { $groups ->
     [one] A group of given values contradicts the other observations
     *[other] { $groups } groups of given values contradict each other
    }: { $solved ->
     [yes] sigma0 is { $sigma0 }
     *[no] the block has no solution
    } with all of them.
    .why = Without any one of these groups the block fits.
    .do = Check their unit, coordinate system and names.

# $group = "bars"
# $n = 2
# $sigma0 = 1.1
# $factor = 1000.0
# $unit = "mm"
# $other = "none"
# $other_unit = ""
groups_contradict-group = { $n } { $group ->
     [bars] { $n ->
     [one] scale bar
     *[other] scale bars
     }
     [positions] { $n ->
     [one] position
     *[other] positions
     }
     *[control] { $n ->
     [one] control point
     *[other] control points
     }
    }: sigma0 is { $sigma0 } without { $n ->
     [one] it
     *[other] them
    }.
    .do = { $unit ->
     [none] { $other ->
     [none] { "" }
     [positions] Given lengths are { NUM($factor, digits: 5) } times the adjusted lengths: check whether the positions are in { $other_unit }.
     *[control] Given lengths are { NUM($factor, digits: 5) } times the adjusted lengths: check whether the control is in { $other_unit }.
     }
     [degrees] Check whether the positions are longitude and latitude in degrees.
     *[other] Given lengths are { NUM($factor, digits: 5) } times the adjusted lengths: check whether they are in { $unit }{ $other ->
     [none] { "" }
     [positions] { "" }, or the positions in { $other_unit }
     *[control] { "" }, or the control in { $other_unit }
     }.
    }
