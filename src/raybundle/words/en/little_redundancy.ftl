# $redundancy = 4
# $factor = 4.8
# $limit = 2.0
little_redundancy = Redundancy { $redundancy }: sigma0 is known only to a factor of { NUM($factor, digits: 2) } (limit { $limit }).
    .why = Standard deviations are as uncertain (95 % limits), and a wrong orientation may fit equally well.
    .do = Add photographs with more overlap, or mark points.
