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

# $target = "AICON (Schneider), 12 bits"
# $quantity = "radius"
# $size_mm = 2.5
# $page = 1
target_sheet-foot = { $target }, { $quantity ->
        [radius] dot radius
        [spacing] spacing
        *[side] side
    } { NUM($size_mm, digits: 6) } mm{ $page ->
        [0] {""}
        *[other] , page { $page }
    }; print at 100 %

# $radius_mm = 2.5
target_sheet-dots_foot = dots without a code, radius { NUM($radius_mm, digits: 6) } mm; print at 100 %

# $length_mm = 150.0
target_sheet-scale_bar = { NUM($length_mm, digits: 6) } mm from first to last tick: measure it on the print

# $x = 1
# $y = 2
# $columns = 3
# $rows = 2
target_sheet-part = column { $x }, row { $y } of { $columns } x { $rows } from the lower left

# $overlap_mm = 10.0
target_sheet-overlap = (parts share { NUM($overlap_mm, digits: 6) } mm; lay cross on cross)
