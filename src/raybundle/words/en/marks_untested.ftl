# $n = 4
# $points = ["P12"]
marks_untested = { $n } { $n ->
        [one] mark is
       *[other] marks are
    } not tested (points: { LIST($points, most: 3) }).
    .why = An error of ten standard deviations of such a mark may remain undetected.
    .do = Measure these points in another photograph, from another direction.
