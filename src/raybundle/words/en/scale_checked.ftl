# $n = 4
# $scale_ppm = 12.0
# $sigma_ppm = 18.0
# $bars = 1
# $ids = ["B1"]
scale_checked = The scale of { $bars } scale { $bars ->
        [one] bar
       *[other] bars
     } ({ $ids }) is confirmed by { $n } check { $n ->
        [one] length
       *[other] lengths
     }.
    .why = Measured lengths differ by { NUM($scale_ppm, digits: 2) } ± { NUM($sigma_ppm, digits: 2) } ppm.
