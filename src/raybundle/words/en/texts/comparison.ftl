# $name = "camcal21-result"
# $known = true
# $sigma0 = 1.023456
# $redundancy = 2310
comparison-result = { $name }: { $known ->
        [yes] sigma0 { NUM($sigma0, digits: 6) }
        *[no] sigma0 unknown
    }, redundancy { $redundancy }.

# $table = "points.csv"
comparison-other_rows = Rows or texts differ: { $table }.

# $n = 5
# $equal = 3
# $difference = 1e-12
# $where = "points.csv, X"
comparison-same_tables = Tables equal to the last bit: { $equal } of { $n }{ $difference ->
        [0] {""}
        *[other] ; largest relative difference { NUM($difference, digits: 1) } ({ $where })
    }.
