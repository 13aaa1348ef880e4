# $sigma_deg = 2.1
up_without_edges = Vertical from how the photographs were held, ± { NUM($sigma_deg, digits: 2) }°; no plumb edges were found.
