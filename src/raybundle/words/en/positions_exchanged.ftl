# $first = "IMG_1"
# $second = "IMG_2"
# $before_m = 45.0
# $after_m = 0.1
# $ids = ["IMG_1", "IMG_2"]
positions_exchanged = The positions of { $first } and { $second } seem to be exchanged; neither is used.
    .why = They are { NUM($before_m, digits: 2) } m from where the photographs and the other positions place them, exchanged { NUM($after_m, digits: 2) } m.
    .do = Check the names in the file of positions, or the clock of the receiver.
