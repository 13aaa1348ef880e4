# $n = 2
# $point = "A"
# $w = 6.1
# $limit = 4.2
# $ids = ["A", "B"]
control_not_located = One of { $n } control points is wrong, which one is ambiguous: { $ids }.
    .why = All of them take part (|w| { NUM($w, decimals: 1) } at { $point }, limit { NUM($limit, decimals: 1) }), so the wrong one distorts the result.
    .do = Check their coordinates and marks, or add control points.

# $point = "A"
# $w = 6.1
# $n = 1
# $part = "scale"
# $ids = ["A"]
control_not_located-datum = Control point { $point } contradicts the other observations (|w| { NUM($w, decimals: 1) }) and still takes part.
    .why = Without it the observations do not determine: { datum-part }.
    .do = Check its coordinates and marks, and measure more control points.

# $point = "A"
# $w = 6.1
# $ids = ["A"]
control_not_located-unfinished = Control point { $point } contradicts the other observations (|w| { NUM($w, decimals: 1) }) and still takes part.
    .why = The adjustment with it did not converge, so the test is not reliable.
    .do = Check its coordinates and marks.
