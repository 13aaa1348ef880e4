# $name = "bench"
# $points = ["A7"]
measurement-unknown_points = { $name } has no point { $points }.
    .do = Correct the point names.

# $name = "bench"
# $n = 5
# $xyz = [4, 3]
# $covariance = [15, 15]
measurement-shapes = { $name }: { $n } names, coordinates of shape ({ $xyz }), covariance of shape ({ $covariance }).
    .do = Give (n, 3) coordinates and a (3n, 3n) covariance matrix.

# $name = "bench"
# $point = "A1"
measurement-point_twice = { $name } contains point { $point } twice.
    .do = Delete or rename one of them.
