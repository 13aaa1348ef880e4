# $name = "control.csv"
# $off_mm = 0.12
control_file-no_sigma = { $name } contains no standard deviations; { NUM($off_mm, digits: 2) } mm is assumed, as its points fit the network.
    .do = Give sX, sY, sZ if they are known.

# $n = 2
# $ids = ["A", "B"]
control_file-not_measured = { $n } control { $n ->
        [one] point was
       *[other] points were
     } not measured: { LIST($ids, most: 10) }.

# $name = "control.csv"
control_file-tolerance = The column tolerance of { $name } is not used: it belongs to nominal coordinates.
