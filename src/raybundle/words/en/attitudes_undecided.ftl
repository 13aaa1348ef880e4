# $source = "eo.txt"
# $ids = ["opk-deg", "opk-gon"]
# $n = 3
# $needed = 4
# $first = "opk-deg"
attitudes_undecided = The attitudes of { $source } are not used: they may be { $ids }.
    .why = The photographs decide between these from { $needed } oriented photographs on; there are { $n }.
    .do = Give the right one, e.g. { OPTION("attitudes", $first) }.
