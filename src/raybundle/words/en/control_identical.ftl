# $pairs = 1
# $ids = ["A", "B"]
control_identical = { $pairs } { $pairs ->
        [one] pair
       *[other] pairs
     } of control points with the same coordinates { $pairs ->
        [one] is
       *[other] are
     } different points: { $ids }.
    .why = A line of the file may have been copied.
    .do = Give each point its own coordinates, or leave it out.

# $pairs = 1
# $ids = ["A", "B"]
control_identical-alike = { $pairs } { $pairs ->
        [one] pair of control points has
       *[other] pairs of control points have
     } the same coordinates within their standard deviation: { $ids }.
    .why = The standard deviations do not separate these points.
    .do = Give one name to what is one point, or correct the standard deviations.

# $first = "A"
# $second = "B"
control_identical-pair = One pair is { $first } and { $second }.

# $first = "A"
# $second = "B"
# $apart_px = 120.0
# $image = "IMG_1"
control_identical-pair_apart = One pair is { $first } and { $second }: { NUM($apart_px, decimals: 0) } px apart in image { $image }.
