# $n = 4
# $points = ["P12"]
# $unseen_px = 5.4
marks_untested = Of { $n } { $n ->
        [one] mark
       *[other] marks
    } errors up to { NUM($unseen_px, digits: 2) } px may remain undetected (points: { LIST($points, most: 3) }).
    .why = That is more than ten times their standard deviation; the other marks of the point hardly test them.
    .do = Measure these points in another photograph, from another direction.

# $n = 4
# $points = ["P12"]
marks_untested-open = { $n } { $n ->
        [one] mark is
       *[other] marks are
    } not tested (points: { LIST($points, most: 3) }).
    .why = An error of any size along the rays of the other marks remains undetected.
    .do = Measure these points in another photograph, from another direction.
