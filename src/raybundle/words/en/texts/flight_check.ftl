

flight_check-sharpness = sharpness of photographs

# $planned = 200
# $taken = 190
# $missing = 10
# $beside = 0
flight_check-photographs = Photographs: { $planned } planned, { $taken } taken; { $missing } missing, { $beside } beside the plan.

flight_check-nothing_again = No place must be flown again.

# $n = 1
# $area_m2 = 420.0
flight_check-gaps = To be flown again: { $n } { $n ->
        [one] gap
        *[other] gaps
    }, { NUM($area_m2, decimals: 0) } m2.

# $along = 0.8
# $along_least = 0.72
# $across_known = true
# $across = 0.7
# $across_least = 0.61
# $wanted = [80.0, 70.0]
flight_check-overlap = Overlap (median, least; { $wanted } % planned): along { PERCENT($along) }, { PERCENT($along_least) } %{ $across_known ->
        [yes] , across { PERCENT($across) }, { PERCENT($across_least) } %
        *[no] {""}
    }.

# $area_m2 = 420.0
# $place = [533000.0, 5537000.0]
# $seen = 2
# $wanted = 4
flight_check-gap = Gap: { NUM($area_m2, decimals: 0) } m2 at { $place }, seen { $seen } times of { $wanted }.

# $line_name = "line 3"
# $n = 4
flight_check-missing_of_line = Missing: { $line_name }: { $n }.

# $median_m = 0.8
# $largest_m = 2.1
flight_check-off_plan = Distance from the plan: median { NUM($median_m, decimals: 1) } m, largest { NUM($largest_m, decimals: 1) } m.

# $largest_m = 2.1
# $offset_m = 0.0
flight_check-off_height = Height differences: largest { NUM($largest_m, decimals: 1) } m{ $offset_m ->
        [0] {""}
        *[other] {" "}after { NUM($offset_m, decimals: 1) } m for all
    }.

# $median_deg = 0.8
# $largest_deg = 4.2
# $name = "IMG_7.JPG"
flight_check-off_view = View off by { NUM($median_deg, decimals: 1) } deg (median), { NUM($largest_deg, decimals: 1) } deg (largest, { $name }).

flight_check-no_attitude = The photographs record no attitude; the planned one is assumed.

# $median_px = 0.4
# $largest_px = 0.9
flight_check-motion = Motion blur: median { NUM($median_px, decimals: 2) } px, largest { NUM($largest_px, decimals: 2) } px.
