# $n = 20
# $points = false
# $target = "AICON (Schneider), 12 bits"
# $pages = 2
# $paper = "A4"
# $tiles = 0
# $tile = ""
target_sheet-printed = { $n } { $points ->
        [yes] points
        *[no] targets
    } of { $target } on { $pages } { $pages ->
        [one] page
        *[other] pages
    } { $paper }{ $tiles ->
        [0] {""}
        *[other] , printed as { $tiles } pages { $tile }
    }.

# $n = 10
# $target = "AICON (Schneider), 12 bits"
target_sheet-chosen = Chosen: { $n } targets of { $target }.

# $hidden = 3
# $bits = 12
# $distance = 4
target_sheet-distinct = Distinct with any { $hidden } neighbouring of { $bits } sectors hidden; least distance { $distance } sectors.
