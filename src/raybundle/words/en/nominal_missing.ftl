# $n = 3
# $ids = ["4", "5", "6"]
nominal_missing = { $n } nominal { $n ->
        [one] point was
       *[other] points were
     } not measured: { LIST($ids, most: 10) }.
