# $n = 2
# $ids = ["t12", "t40"]
approximate_values_replaced-points = { $n } tie { $n ->
        [one] point was
       *[other] points were
    } far from the rays and intersected again: { $ids }.
    .do = Check points.csv.

# $sigma0 = 1.02
approximate_values_replaced-unsolvable = The approximate values of the block lead to no solution and were replaced (sigma0 now { $sigma0 }).
    .do = Check images.csv and points.csv.

# $given_sigma0 = 12.4
# $sigma0 = 1.02
approximate_values_replaced-poor = The approximate values of the block lead to sigma0 { $given_sigma0 } and were replaced (sigma0 now { $sigma0 }).
    .do = Check images.csv and points.csv.

# $n = 120
# $sigma0 = 1.02
approximate_values_replaced-behind = The approximate values lead to { $n } image points behind cameras and were replaced (sigma0 now { $sigma0 }).
    .do = Check images.csv and points.csv.
