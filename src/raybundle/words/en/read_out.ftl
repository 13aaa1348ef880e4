# $time_ms = 24.0
# $sigma_ms = 1.2
# $by_read_out = 410.0
# $by_shape = 120.0
read_out-time = A read-out time of { NUM($time_ms, decimals: 0) } ± { NUM($sigma_ms, decimals: 0) } ms reduces chi-square by { NUM($by_read_out, decimals: 0) }, affinity and shear by { NUM($by_shape, decimals: 0) }.

# $share = 0.012
# $by_read_out = 410.0
# $by_shape = 120.0
read_out-share = A read-out of { PERCENT($share) } % of the photo interval reduces chi-square by { NUM($by_read_out, decimals: 0) }, affinity and shear by { NUM($by_shape, decimals: 0) }.

# $time_ms = 24.0
# $sigma_share = 0.1
read_out-given = The given read-out time of { $time_ms } ms is observed with { PERCENT($sigma_share) } %.

# $time_ms = 22.0
read_out-table = Published measurements of this camera: { NUM($time_ms, decimals: 0) } ms.

# $n = 4
read_out-still = { $n } { $n ->
        [one] photograph
       *[other] photographs
    } without a velocity (turns, gaps) count as motionless.

# $camera = "p4p"
read_out = Camera { $camera }: the rolling shutter is modelled.
    .why = The velocity of a photograph follows from the projection centres before and after it.
