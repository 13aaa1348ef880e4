# $kind = "distances"
# $name = "M1-M2"
# $component = ""
# $given = 1.0003
# $shown = 1.0123
# $off = 0.012
# $sigma = 0.0001
# $unit = "m"
# $w = 6.1
# $limit = 4.2
# $others = ["M3-M4"]
# $ids = ["M1-M2"]
suspect-value = { $name } { $component } ({ observations-kind }) contradicts the other observations by { NUM($off, digits: 2) } { $unit }.
    .why = Given: { NUM($given, digits: 12) } { $unit }, by the others { NUM($shown, digits: 12) } { $unit } (sigma { $sigma } { $unit }, |w| { NUM($w, decimals: 1) }, limit { NUM($limit, decimals: 1) }).
    .do = Check this value.

# $name = "M1-M2"
# $names = ["M3-M4"]
suspect-others = { LIST($names, most: 10) } may be wrong instead of { $name }; the observations cannot separate these values.

# $name = "M1-M2"
# $names = ["M3-M4"]
suspect-beside = If { $name } is corrected, the test no longer rejects { LIST($names, most: 10) }.
    .do = Correct { $name } first, then adjust again.
