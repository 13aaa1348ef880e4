report_reliability-title = Reliability

report_reliability-no_statistics = Redundancy numbers and tests were not computed (statistics are off).

report_reliability-largest = Largest residuals

report_reliability-no_redundancy_number = No image observation has a redundancy number.

# $mean = 0.612
# $least = 0.013
report_reliability-redundancy = Redundancy numbers r of image coordinates: mean { NUM($mean, decimals: 3) }, smallest { NUM($least, decimals: 3) }.
    .why = r is the share of an observation's error that appears in its own residual.

# $n = 123
# $share = 0.032
# $limit = 0.1
report_reliability-poor = { $n } image { $n ->
        [one] coordinate has
        *[other] coordinates have
    } r below { $limit } ({ PERCENT($share) } %).
    .why = A blunder there affects the result almost in full.

# $n = 12
# $share = 0.0031
# $least = -0.042
report_reliability-below_zero = { $n } redundancy { $n ->
        [one] number is
        *[other] numbers are
    } below 0 ({ PERCENT($share) } %), down to { NUM($least, decimals: 3) }.
    .why = This is no error: x and y of these observations are correlated. Tests and minimal detectable biases use the variance of P v, which is positive.

# $smaller_from = 0.02
# $smaller_to = 0.11
# $larger_from = 0.45
# $larger_to = 0.93
report_reliability-eigenvalues = The eigenvalues of the 2 × 2 block of each of these points are within 0 … 1.
    .why = The smaller ones are { NUM($smaller_from, decimals: 3) } to { NUM($smaller_to, decimals: 3) }, the larger ones { NUM($larger_from, decimals: 3) } to { NUM($larger_to, decimals: 3) }; their sum is r x + r y.

# $camera = "1"
report_reliability-map = Mean redundancy number over the format, camera { $camera }; red: hardly controlled by other observations.

report_reliability-histogram = Redundancy numbers of the image coordinates.

report_reliability-of_images = Mean redundancy number of each image.

report_reliability-detectable_heading = Minimal detectable biases

report_reliability-uncontrolled = No image observation is controlled: no blunder can be detected.

# $median = 0.52
# $most = 0.94
# $largest = 4.1
# $power = 0.8
# $level = 0.001
report_reliability-detectable = Minimal detectable bias of an image coordinate: { $median } px (median), { $most } px (95 %), { $largest } px (all).
    .why = It is detected with a probability of { PERCENT($power) } % at a level of { PERCENT($level) } %.

# $median = 0.52
# $most = 0.94
# $largest = 4.1
# $unit = "mm"
report_reliability-effect = Undetected, it moves its object point by { $median } (median), { $most } (95 %), { $largest } { $unit } (largest) at most.

# $n = 40
# $limit = 0.001
report_reliability-untested = Not counted: { $n } image { $n ->
        [one] coordinate
        *[other] coordinates
    } with r below { $limit }, where no blunder is detected.
    .why = These are coordinates along the epipolar line of points with two rays.

report_reliability-weakest_list = The weakest image coordinates

report_reliability-effect_on_point = effect on the point

report_reliability-weakest = Image coordinates with the largest effect of an undetected blunder

# $n = 20
report_reliability-largest_note = The { $n } largest |w|. w = v / (s √r) with the a-priori standard deviation, τ = w / σ₀.

# $limit = 4.2
report_reliability-marked = Marked: |τ| above its critical value for all tests together, { $limit }.

report_reliability-rejected = Rejected observations

report_reliability-none_rejected = No image observation was rejected.

# $n = 31
# $share = 0.012
report_reliability-rejected_share = Rejected: { $n } image { $n ->
        [one] observation
        *[other] observations
    } ({ PERCENT($share) } %).

report_reliability-rejected_list = List of rejected observations

report_reliability-suspects = Suspects and their separability

report_reliability-correlation_of_suspects = largest correlation with another

report_reliability-suspects_note = If the test values of two suspects correlate strongly, only one of them may be wrong.

report_reliability-single_test = |w| of a single test

# $symbol = "w"
report_reliability-all_tests = |{ $symbol }|, all tests together

report_reliability-noncentrality = detectable shift of w

# $level = 0.001
# $power = 0.8
report_reliability-level_and_power = { PERCENT($level) } %, power { PERCENT($power) } %

report_reliability-critical_values = Critical values
