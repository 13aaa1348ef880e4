costs-measure_and_shipped = { OPTION("measure", "True") } and { OPTION("shipped", "True", flag: "no-measure") } exclude each other.
    .do = Give one of them.

costs-no_photographs = The number of photographs is unknown.
    .do = Give their folder, or { OPTION("images", "N") }.

# $n = 120
costs-photographs_and_number = Photographs and { OPTION("images", $n) } exclude each other.
    .do = Give one of them.

# $along = 0.2
# $across = 0.1
# $n = 1.39
# $needed = 2.0
costs-overlap_too_small = { OPTION("flight_overlap", $along, $across) }: a place is in { $n } photographs; { $needed } are needed.
    .do = Give at least 0.6 along and 0.3 across.

# $what = "memory"
# $needed = "24 GB"
# $given = "16 GB"
costs-exceeded = { $what }: { $needed } needed, { $given } available.

# $n = 1
# $names = ["a.jpg"]
costs-unread = { $n } unreadable { $n ->
        [one] file is
        *[other] files are
    } not counted: { $names }.
