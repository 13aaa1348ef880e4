# $network = "2026"
# $n = 5
# $least = -1e-09
# $limit = 1e-12
network-covariance_not_positive = Network { $network }: the covariance matrix of its { $n } points is not positive definite.
    .why = The least eigenvalue of the correlations is { $least } (limit { $limit }); a network without datum has a singular covariance matrix.
    .do = Add the covariances of the datum points, or write the values with ten digits.

# $point = "A1"
# $network = "2026"
network-point_given_twice = Point { $point } is in coordinates.csv (network { $network }) and is control with standard deviations in points.csv.
    .why = Its coordinates would be counted twice.
    .do = Delete it from one of the two files.
