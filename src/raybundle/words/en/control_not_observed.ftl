# $n = 2
# $ids = ["A", "B"]
control_not_observed = { $n } control { $n ->
        [one] point is
       *[other] points are
     } measured in no image and { $n ->
        [one] takes
       *[other] take
     } no part: { $ids }.
    .do = Measure { $n ->
        [one] it
       *[other] them
     } in the images, or correct the names. `raybundle mark find PROJECT` finds ground panels.

# $n = 2
# $ids = ["A", "B"]
control_not_observed-rejected = { $n } control { $n ->
        [one] point takes
       *[other] points take
     } no part: all image points were rejected ({ $ids }).
    .do = Check coordinates, names and marks.
