# $name = "control.csv"
# $n = 1
# $rms_mm = 0.03
# $ids = ["A"]
control_left_out = { $n } control { $n ->
        [one] point
       *[other] points
     } of { $name } { $n ->
        [one] contradicts
       *[other] contradict
     } the others and { $n ->
        [one] is
       *[other] are
     } excluded: { $ids }.
    .why = The others agree to { NUM($rms_mm, digits: 2) } mm rms; excluded points are compared with the result.
    .do = Check their coordinates and names.

# $n = 4
# $ids = ["A", "B"]
control_left_out-unsolvable = All control ({ $n } { $n ->
        [one] point
       *[other] points
    }) is excluded: with it there is no solution.
    .why = Position, orientation and scale are approximate.
    .do = Check coordinates, names and measurements of the control: { LIST($ids, most: 8) }.
