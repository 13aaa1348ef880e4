# $n = 3
# $ids = ["4", "5", "6"]
nominal_missing = { $n } nominal { $n ->
        [one] point was
       *[other] points were
     } not measured: { LIST($ids, most: 10) }.
    .why = No deviations of these points are known; the fit rests on the other points.
    .do = Measure these points, or delete them from the nominal coordinates.
