# $sum = 1021.5
# $redundancy = 1020
# $limit = 0.001
redundancy_sum = The redundancy numbers sum to { NUM($sum, decimals: 6) } instead of { $redundancy } (limit { NUM($limit, digits: 2) }).
    .why = Standard deviations are not reliable.
    .do = Report this block as an error of the program.
