# $n = 1
# $point = "A"
# $ids = ["A"]
control_suspect = { $n ->
        [one] Control point { $point } contradicts
       *[other] { $n } control points contradict
     } the other observations{ $n ->
        [one] { "" }
       *[other] : { $ids }
     }.
    .why = { $n ->
        [one] It takes
       *[other] They take
     } part and { $n ->
        [one] distorts
       *[other] distort
     } the result.
    .do = Check { $n ->
        [one] its coordinates and its number
       *[other] their coordinates and their numbers
     } in the images.

# $point = "A"
# $w = 6.1
# $limit = 4.2
# $dx = 0.2
# $dy = -0.1
# $dz = 0.0
# $unit = "m"
control_suspect-point = { $point }: the other observations move it by { NUM($dx, digits: 3) }, { NUM($dy, digits: 3) }, { NUM($dz, digits: 3) } { $unit } (|w| { NUM($w, decimals: 1) }, limit { NUM($limit, decimals: 1) }).

# $n = 2
# $names = ["B", "C"]
control_suspect-swayed = { LIST($names, most: 10) } { $n ->
        [one] fails
       *[other] fail
     } the test only because of this.

# $n = 4
# $ids = ["A", "B"]
control_suspect-unexplained = Control and the other observations contradict each other, most of all at { $ids }.
    .why = A few wrong points do not explain it.
    .do = Check names, axes, unit and coordinate system of the control, or give it larger standard deviations.
