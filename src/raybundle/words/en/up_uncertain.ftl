# $sigma_deg = 8.0
up_uncertain = The vertical is uncertain by ± { NUM($sigma_deg, decimals: 0) }°: it is taken from how the photographs were held.
    .do = Give two measured points, B plumb above A: { OPTION("up", "A,B") }.
