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

# $stable = 160
# $other = 155
# $points = 300
epochs-stable_ambiguous = Two sets of stable points fit equally well: { $stable } and { $other } of { $points } points.
    .why = Nearly half moved alike. What is reported as moved may be what stayed.
    .do = Give the stable points with { OPTION("datum_points", "A", "B", "C") }.

# $names = ["autumn"]
# $scale_ppm = [120.0]
epochs-free_scale = The scale of { $names } is not fixed: a growth of all points is not detected ({ $scale_ppm } ppm).
    .why = Control is free in this test; lengths are those of the first epoch.
    .do = Measure a scale bar in each epoch.

# $points = ["A7"]
epochs-points_unknown = No measurement has { LIST($points, most: 10) }.
    .do = Correct { OPTION("points") }.

# $epochs = ["2026-05-01", "2026-06-01"]
epochs-joint_order = The joint covariance of { $epochs } needs the same points in the same order.
    .do = Give all epochs with the same points.

# $name = "wall"
epochs-group_empty = No point of group { $name } has a place at every date.
    .do = Correct { OPTION("group") }.

# $name = "rock"
# $names = ["R9"]
epochs-group_without = Group { $name } is tested without { LIST($names, most: 5) }.
    .why = No point with such a name has a place at every date.
    .do = Correct { OPTION("group") }.

# $text = "wall"
epochs-group_text = { $text } is no group.
    .do = Give { OPTION("group", "NAME:A,B,C") } or { OPTION("group", "NAME:outline.csv") }.

# $n = 2
# $least = 6
# $date = "2026-07-01"
# $common = 2
# $photographs = 2
epochs-dates_not_joined = { $date } has { $common } points in common with other dates; all dates have { $n } ({ $least } are needed).
    .why = It has { $photographs } { $photographs ->
        [one] photograph
        *[other] photographs
    }; two must show a point.
    .do = Take photographs of the same place from similar sides at each date, or delete { $date } from [epochs] of project.toml.

# $dates = ["2026-05-01"]
epochs-one_date = Displacements need images of at least two dates; there is { LIST($dates, most: 1) }.
    .do = Add photographs of another date.

# $text = "May"
epochs-no_date_text = { $text } is no date.
    .do = Give it as YYYY-MM-DD.

# $n = 2
# $names = ["a.jpg", "b.jpg"]
epochs-photographs_without_date = { $n } { $n ->
        [one] photograph has
        *[other] photographs have
    } no date: { LIST($names, most: 5) }.
    .do = Add them with { OPTION("date", "YYYY-MM-DD") }.

# $start = "2026-05-01"
# $end = "2026-06-01"
# $days = 31
# $first = "2026-06-01"
# $last = "2026-05-01"
# $taken = -31
epochs-dates_contradict = Photographs of { $start } and { $end } were taken on { $first } and { $last } (EXIF).
    .why = The dates are { $days } days apart, the photographs { $taken }. Displacements and velocities are stated by the dates.
    .do = Check { OPTION("date", "YYYY-MM-DD") }. If the clock of the camera was reset, nothing is wrong.

# $date = "2026-05-01"
# $first = "2026-05-01"
# $last = "2026-06-01"
epochs-date_of_many_days = Photographs of { $date } were taken from { $first } to { $last } (EXIF).
    .why = What moved between these days contradicts within the date.
    .do = Put photographs of each date into a folder of their own.

# $add = 2
# $dates = 1
epochs-dates_not_paired = { $add } folders are added with { $dates } { $dates ->
        [one] date
        *[other] dates
    }.
    .do = Give one date for each folder, or none.

# $project = "dam"
epochs-no_photographs = { $project } has no photographs.
    .do = Add photographs with { OPTION("add", "PHOTOS") }.

# $date = "2026-07-01"
# $n = 2
# $total = 3
# $whole = false
# $copies = 1
# $unusable = 1
# $lost = 0
# $names = ["a.jpg", "b.jpg"]
epochs-photographs_left_out = { $date }: { $n } of { $total } photographs take no part: { LIST($names, most: 3) }{ $copies ->
        [0] {""}
       *[other] ; copies: { $copies }
    }{ $unusable ->
        [0] {""}
       *[other] ; unusable: { $unusable }
    }{ $lost ->
        [0] {""}
       *[other] ; not oriented: { $lost }
    }.
    .why = { $whole ->
        [yes] There are no displacements of this date
       *[no] Displacements of this date are less precise
    }.
    .do = Replace or delete photographs that take no part.

# $folder = "july"
epochs-source_empty = { $folder } has no photographs of its own.
    .why = It is empty, or its photographs are links to earlier ones.
    .do = Correct { OPTION("add", "PHOTOS") }.

# $text = "10 feet"
epochs-limit = { $text } is no length.
    .do = Give { OPTION("limit", "10mm") }.

# $limit = "10mm"
epochs-limit_not_tested = { $limit } is not tested: lengths have no scale.
    .do = Add control, a scale bar or positions of the photographs.

epochs-no_scale = Lengths have no scale, and are in no unit.
    .do = Add control, a scale bar or positions of the photographs.

# $camera = "1"
# $F = 5.2
# $p = 0.0001
epochs-camera_changed = Camera { $camera } has another interior orientation at each date (F { NUM($F) }, { P($p) }).
    .why = Each date has its own camera parameters, which are less precise.
    .do = Fix focus and zoom between the dates.

# $n = 3
# $name = "t17"
# $end = "2026-06-01"
# $length_mm = 12.3
# $limit = "10mm"
# $confidence = 0.99
epochs-limit_exceeded = { $n } { $n ->
        [one] displacement exceeds
        *[other] displacements exceed
    } { $limit }: { $name } { NUM($length_mm, digits: 3) } mm until { $end } (probability over { PERCENT($confidence) } %).
    .do = Inspect { $name }.

# $limit = "10mm"
# $confidence = 0.99
# $tested = 1300
# $points = 1300
epochs-limit_kept = At { $tested } of { $points } points the limit { $limit } is tested; no displacement exceeds it there ({ PERCENT($confidence) } %).

# $limit = "10mm"
# $n = 12
# $points = 1300
# $largest_mm = 38.0
epochs-limit_below_detection = { $limit } is not tested at { $n } of { $points } points: below what is detectable there.
    .why = The smallest detectable displacement is up to { NUM($largest_mm, digits: 3) } mm.
    .do = Take more photographs at each date, or give a larger limit. Column `detectable` of displacements.csv.

epochs-no_animation = The animation of the dates was not written.
    .do = Check that photographs of all dates show the same part of the object.
