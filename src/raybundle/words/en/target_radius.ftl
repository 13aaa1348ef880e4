# $ratio = 1.042
# $sigma = 0.004
target_radius = Target radii are { NUM($ratio, decimals: 3) } ± { NUM($sigma, decimals: 3) } times those seen in the images; the factor is estimated.
