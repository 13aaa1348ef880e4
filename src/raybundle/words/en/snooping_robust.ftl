# $rejected = 200
# $ratio = 9.0
snooping_robust = { $rejected } image observations were rejected after a robust estimate.
    .why = The blunders masked one another in the test of single observations (sigma0 { NUM($ratio, digits: 2) } times the scale of the median residual).
