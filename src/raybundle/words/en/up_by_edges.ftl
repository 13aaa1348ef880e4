# $edges = 832
# $photographs = 8
# $sigma_deg = 0.12
up_by_edges = Vertical from { $edges } plumb edges in { $photographs } photographs, ± { NUM($sigma_deg, digits: 2) }°.
