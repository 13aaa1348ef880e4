# $names = ["D1", "D4"]
epochs-datum_points_missing = Datum points are not measured in all epochs: { $names }.
    .do = Select datum points that all epochs have.

epochs-only_one = A congruence test needs at least two epochs.
    .do = Give two or more measurements.

# $epochs = ["before", "after"]
# $n = 3
# $least = 4
epochs-too_few_common = { $epochs }: { $n } points have common names; { $least } are needed.
    .why = Three points define the datum, and one more can be tested.
    .do = Use the same point names in all epochs.

# $first = "before"
# $second = "after"
epochs-no_sigmas = { $first } and { $second } have no standard deviations.
    .why = Without them no displacement can be tested.
    .do = Give results with covariances.

epochs-covariance_singular = The joint covariance matrix of the epochs is singular beyond the datum.
    .why = Points that are held without error cannot be tested.
    .do = Adjust the epochs as free networks.

# $first = "after"
# $second = "before"
# $n = 12
# $agree = 5
# $rms_mm = 0.31
# $rms_same_scale_mm = 2.4
# $factor = 1.0012
# $factor_sigma = 2e-05
# $scale_ppm = 1200.0
# $sigma_ppm = 20.0
# $near_1 = true
# $units = ""
epochs-mirrored = The points of { $first } and { $second } are mirror images: mirrored they fit to { NUM($rms_mm, digits: 2) } mm rms.
    .do = Check the axes of both, and whether images were mirrored.

# $first = "after"
# $second = "before"
# $n = 12
# $agree = 5
# $rms_mm = 0.31
# $rms_same_scale_mm = 2.4
# $factor = 1.0012
# $factor_sigma = 2e-05
# $scale_ppm = 1200.0
# $sigma_ppm = 20.0
# $near_1 = true
# $units = ""
epochs-scattered = The points of { $first } and { $second } do not fit: only { $agree } of { $n } agree.
    .why = The names belong to other objects, or are exchanged.
    .do = Check the point names of both epochs.

# $first = "after"
# $second = "before"
# $n = 12
# $agree = 5
# $rms_mm = 0.31
# $rms_same_scale_mm = 2.4
# $factor = 1000.2
# $factor_sigma = 2e-05
# $scale_ppm = 1200.0
# $sigma_ppm = 20.0
# $near_1 = false
# $units = "mm for m"
epochs-other_unit = Distances in { $first } are { NUM($factor, digits: 6) } times those in { $second }.
    .why = The length unit of one of them is wrong (likely { $units }).
    .do = Correct the length unit or the scale bar.

# $n = 4
# $epochs = ["before", "after"]
# $epoch = "before"
# $names = ["1", "2", "3", "4"]
epochs-points_in_line = The { $n } common points lie in one line, or are one point, in { $epoch }.
    .why = A datum needs three points that are not in one line ({ $names }).
    .do = Measure common points beside this line.

# $first = "a"
# $second = "b"
# $apart_mm = 0.0001
# $sigma_mm = 0.03
epochs-same_observations = { $first } and { $second } are the same measurement (differences { NUM($apart_mm, digits: 2) } mm, sigma { NUM($sigma_mm, digits: 2) } mm).
    .why = A measurement compared with itself shows no displacement.
    .do = Give the result of another epoch.

# $name = "spring-result"
# $n = 2
epochs-faulty = { $name } has { $n } { $n ->
        [one] fault
        *[other] faults
    } of its own.
    .why = Displacements against it are not reliable.
    .do = Settle the faults of { $name } first.

# $p = 0.001
epochs-stable_points_differ = Stable points differ by more than their standard deviations ({ P($p) }).
    .why = The standard deviations are too small, or many points moved a little.
    .do = Give the stable points with { OPTION("datum_points", "A", "B", "C") }.

# $names = ["autumn"]
# $scale_ppm = [120.0]
epochs-free_scale = The scale of { $names } is not fixed: a growth of all points is not detected ({ $scale_ppm } ppm).
    .why = Control is free in this test; lengths are those of the first epoch.
    .do = Measure a scale bar in each epoch.

# $points = ["A7"]
epochs-points_unknown = No measurement has { LIST($points, most: 10) }.
    .do = Correct { OPTION("points") }.
