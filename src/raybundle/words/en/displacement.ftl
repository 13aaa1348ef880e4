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
