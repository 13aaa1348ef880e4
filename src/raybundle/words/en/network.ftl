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

# $network = "2026"
network-pair_twice = These two points of network { $network } are in an earlier row.
    .do = Delete one of the two rows.

network-coordinates_missing = The coordinates of the point are missing (point and other are the same).
    .do = Give X, Y and Z.

network-coordinates_of_pair = A row of two different points has coordinates.
    .do = Leave X, Y and Z empty.

# $network = "2026"
network-point_without_coordinates = Network { $network } has no row with the coordinates of one of the two points.
    .do = Add a row in which point and other are this point.

# $variance = -0.01
network-variance_not_positive = A variance is { $variance }; it must be positive.

network-covariance_not_symmetric = The covariance matrix of the point is not symmetric.
    .do = Correct cXY, cXZ and cYZ.

network-no_depth = The rays to every object point are parallel: the network has no base.
    .why = The photographs were taken from one place, or show a flat object squarely.
    .do = Add photographs from other places, apart by at least a tenth of the object distance.
