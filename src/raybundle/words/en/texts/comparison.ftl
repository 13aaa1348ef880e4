# $name = "camcal21-result"
# $known = true
# $sigma0 = 1.023456
# $redundancy = 2310
comparison-result = { $name }: { $known ->
        [yes] sigma0 { NUM($sigma0, digits: 6) }
        *[no] sigma0 unknown
    }, redundancy { $redundancy }.

# $table = "points.csv"
# $n = 5
# $equal = 3
# $difference = 1e-12
# $where = "points.csv, X"