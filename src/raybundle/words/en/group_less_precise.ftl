# $kind = "stations"
# $ratio = 3.4
# $sigma0 = 1.2
# $count = 54
# $redundancy = 40.2
# $ids = ["stations"]
group_less_precise = Residuals of { observations-kind } are { NUM($ratio, digits: 3) } times as large as stated (all observations: { $sigma0 }).
    .why = This is significant for { $count } values with redundancy { NUM($redundancy, decimals: 1) }.
    .do = Look for a common cause such as a wrong datum, or enlarge the standard deviations by this factor.

# $kind = "stations"
# $ratio = 3.4
# $count = 54
# $redundancy = 40.2
# $ids = ["stations"]
group_less_precise-weighted = Residuals of { observations-kind } are { NUM($ratio, digits: 3) } times as large as stated.
    .why = Their standard deviations were enlarged by this factor ({ $count } values, redundancy { NUM($redundancy, digits: 3) }), which is right for random errors only.
    .do = Look for a common cause such as a wrong datum or a bias of the positions.
