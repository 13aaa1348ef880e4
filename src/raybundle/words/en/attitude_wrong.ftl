# $n = 2
# $off_deg = 12.5
# $scatter_deg = 0.05
# $ids = ["IMG_1", "IMG_2"]
attitude_wrong = { $n } { $n ->
     [one] attitude contradicts
     *[other] attitudes contradict
    } the photographs by up to { NUM($off_deg, decimals: 1) }° and { $n ->
     [one] is
     *[other] are
    } left out: { $ids }.
    .why = The others scatter by { NUM($scatter_deg, decimals: 2) }°.
