# $point = "7"
# $others = ["9"]
# $F = 1.12
# $ids = ["7"]
moved_ambiguous = Point { $point } is reported as moved; { $others } may have moved instead.
    .why = Both explanations fit (F { NUM($F, decimals: 2) } without { $point }).
    .do = Measure more common points.

# $point = "9"
# $F = 1.2
moved_ambiguous-other = Without { $point } the rest agrees equally well (F { NUM($F, decimals: 2) }).
