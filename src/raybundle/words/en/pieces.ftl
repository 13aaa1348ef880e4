# $degree = 4
pieces-degree = Pieces of degree { $degree } are not possible.
    .do = Give degree 1, 2 or 3.

# $continuity = 3
# $degree = 2
# $most = 1
pieces-continuity = Continuity { $continuity } is not possible for pieces of degree { $degree }.
    .do = Give a continuity from 0 to { $most }.

# $n = 40
# $coefficients = 43
# $most = 32
pieces-count = { $n } pieces have { $coefficients } coefficients; 1 to { $most } are possible.
    .do = Give fewer pieces, but at least one.
