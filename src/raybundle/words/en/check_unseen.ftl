# $n = 2
# $ids = ["C1", "C2"]
check_unseen = { $n } check { $n ->
        [one] point has
       *[other] points have
     } fewer than two rays and { $n ->
        [one] is
       *[other] are
     } not compared: { $ids }.
    .do = Measure each check point in at least two photographs. `raybundle mark find PROJECT` finds ground panels.

# $n = 2
# $ids = ["C1", "C2"]
check_unseen-no_measurement = { $n } check { $n ->
     [one] point has
     *[other] points have
    } no usable image measurement: { $ids }.
    .do = Measure each check point in at least two photographs. `raybundle mark find PROJECT` finds ground panels.
