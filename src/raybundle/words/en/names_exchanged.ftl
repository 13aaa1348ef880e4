# $pairs = 1
# $ids = ["A", "B"]
names_exchanged = { $pairs } { $pairs ->
        [one] pair
       *[other] pairs
     } of rejected image points fit{ $pairs ->
        [one] s
       *[other] { "" }
     } with exchanged names: { $ids }.
    .do = Exchange the names in these images.

# $first = "A"
# $second = "B"
# $image = "IMG_1"
names_exchanged-pair = Names { $first } and { $second } seem exchanged in image { $image }.
