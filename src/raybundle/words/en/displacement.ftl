# $n = 40
# $moved = 2
# $names = ["17", "5"]
# $error_rate = 0.05
displacement-points = { $moved ->
        [0] None of { $n } common points displaced
        *[other] { $moved } of { $n } common points displaced: { $names }
    } (false-alarm rate { PERCENT($error_rate) } %).

# $median_mm = 0.2
# $largest_mm = 0.5
displacement-level_of_detection = Level of detection (80 % power): { NUM($median_mm, digits: 2) } mm (median), { NUM($largest_mm, digits: 2) } mm (largest).

displacement-no_level_of_detection = Some displacements cannot be detected: too few points are stable.

# $F = 3.2
# $p = 0.0001
# $F_stable = 1.1
# $p_stable = 0.4
displacement-tests = Congruence of all points F = { $F } ({ P($p) }), of stable points F = { $F_stable } ({ P($p_stable) }).

# $n = 3
displacement-by_place = { $n } { $n ->
        [one] dot is
        *[other] dots are
    } identified by position, not by name.
    .why = A dot that moves by more than half the spacing is taken for another one.

# $file_name = "nominal.csv"
# $points = ["A", "B"]
displacement-axes = Axes X, Y, Z: those of { $file_name }, fitted by { $points }.

# $n = 2
# $limit = 2
displacement-unsure = { $n } { $n ->
    [one] region is
    *[other] regions are
 } no certain movement: the mean of the inner part is less than { $limit } standard deviations.
    .why = Errors at edges and in filled holes are common to the whole region; a window contains only those nearby.

# $date = "2026-05-01"
displacement-one_date = All photographs are of { $date }: no displacements.
    .do = Add photographs of another date with { OPTION("add", "PHOTOS") }.

# $dates = ["2026-05-01", "2026-06-01"]
# $points = 400
# $moved = 2
# $areas = 1
# $names = ["t5", "t17"]
# $error_rate = 0.05
displacement-dates = { LIST($dates, most: 4) }: { $moved ->
        [0] none of { $points } points moved
        *[other] { $moved } of { $points } points moved: { LIST($names, most: 5) }
    }, { $areas ->
        [0] no area
        [one] 1 area
        *[other] { $areas } areas
    } moved (false-alarm rate { PERCENT($error_rate) } %).

# $point = "t17"
# $start = "2026-05-01"
# $end = "2026-06-01"
# $length_mm = 12.3
# $sigma_mm = 0.8
displacement-largest = Largest displacement: { $point }, { NUM($length_mm, digits: 3) } mm ± { NUM($sigma_mm, digits: 2) } mm from { $start } to { $end }.

# $name = "wall"
# $n = 12
# $length_mm = 4.2
# $sigma_mm = 0.3
# $end = "2026-06-01"
displacement-area = { $name } ({ $n } points): mean displacement { NUM($length_mm, digits: 3) } mm ± { NUM($sigma_mm, digits: 2) } mm until { $end }.

# $name = "area 3"
# $n = 12
# $shortest_mm = 3.8
# $longest_mm = 106.0
# $end = "2026-06-01"
displacement-area_uneven = { $name } ({ $n } points): uneven displacement, { NUM($shortest_mm, digits: 2) } mm to { NUM($longest_mm, digits: 3) } mm until { $end }.

# $n = 300
# $median = 0.05
# $largest = 0.8
# $point = "t17"
# $changed = 1
# $verdicts = ["t4"]
# $missing = 3
displacement-changes = { $n } earlier displacements: changed by { NUM($median, digits: 2) } standard deviations (median), { NUM($largest, digits: 2) } (largest, { $point }).
    .why = { $changed } { $changed ->
        [one] point changed
        *[other] points changed
    } by more than one standard deviation. Other verdicts: { LIST($verdicts, most: 5) }. Without counterpart: { $missing }.

# $before = ["2026-05-01", "2026-06-01"]
# $now = ["2026-06-01", "2026-05-01"]
displacement-dates_changed = Dates changed: { LIST($before, most: 5) } became { LIST($now, most: 5) }.
    .why = Earlier displacements are compared by their photographs.

# $n = 300
displacement-not_compared = Of { $n } earlier displacements none is compared: their dates or points have changed.

# $n = 12
# $names = ["t7", "t31"]
displacement-untested = { $n } displaced { $n ->
        [one] point is
        *[other] points are
    } untested: { LIST($names, most: 5) }.
    .why = A wrong image point explains the displacement as well.
    .do = Take more photographs of each date.

# $name = "area 3"
# $speed_mm = 141.0
# $sigma_mm = 9.0
# $n = 14
# $other = 2
# $verdict = "accelerated"
displacement-velocity = Fastest: { $name }, { NUM($speed_mm, digits: 3) } mm ± { NUM($sigma_mm, digits: 2) } mm a year, { $verdict ->
        [constant] constant
        [accelerated] accelerated
        [decelerated] decelerated
       *[irregular] irregular
    } ({ $other } of { $n } motions are not constant).
