# $first = "A"
# $second = "B"
# $before_m = 12.0
# $after_m = 0.02
# $few = false
# $least = 3
# $ids = ["A", "B"]
control_exchanged = Control points { $first } and { $second } seem to be exchanged; { $few ->
     [yes] no control takes part (fewer than { $least } points remain)
     *[no] they take no part
    }.
    .why = They are { NUM($before_m, digits: 2) } m from where the others place them, exchanged { NUM($after_m, digits: 2) } m.
    .do = Exchange their coordinates, or their names in the images.
