# $n = 12
given_rejected = { $n } image { $n ->
        [one] observation was
       *[other] observations were
    } rejected in an earlier adjustment and { $n ->
        [one] takes
       *[other] take
    } no part.
    .do = Delete the column rejected of observations.csv to test them again.
