# $n = 4
# $x = 0.5
# $y = 0.6
empirical-check_points = Check points ({ $n }): rms { $x }, { $y } px.

# $model = "dlt"
# $n = 24
# $redundancy = 30
# $sigma0 = 1.02
empirical-fitted = { $model }: { $n } points, redundancy { $redundancy }, sigma0 { NUM($sigma0, digits: 4) }.

# $limit = 0.95
# $pairs = ["L1 - L4 +0.970"]
empirical-correlations = Correlations beyond { $limit }: { $pairs }.

# $point = "P3"
# $axis = "x"
# $w = 4.2
# $limit = 3.3
# $residual_px = 2.1
empirical-suspect = Check { $point }: w of { $axis } = { $w } (limit { $limit }), residual { $residual_px } px.
