# $n = 231
# $sigma = 0.042
# $unit = "mm"
verdict-points_rms = { $n } object { $n ->
        [one] point
        *[other] points
    }, standard deviation { NUM($sigma, digits: 2) } { $unit } (rms of a coordinate).

# $n = 231
# $sigma = 0.042
# $rms = 0.9
# $unit = "mm"
verdict-points_median = { $n } object points, standard deviation of a coordinate { NUM($sigma, digits: 2) } { $unit } (median; rms { NUM($rms, digits: 2) }).

# $n = 4
# $share = 0.53
# $of = 231
verdict-few_points = { $n } of { $of } points { $n ->
        [one] contributes
        *[other] contribute
    } { PERCENT($share) } % of the variance.

# $n = 231
# $sigma = 3.1
# $unit = "mm"
verdict-points_plan = { $n } object { $n ->
        [one] point
        *[other] points
    }, standard deviation { NUM($sigma, digits: 2) } { $unit } rms in X and Y; heights are relative.

# $n = 231
# $relative = 12000
verdict-points_relative = { $n } object { $n ->
        [one] point
        *[other] points
    }, relative precision 1 : { $relative }; no absolute scale.

# $relative = 12000
verdict-relative = Relative precision 1 : { $relative } (mean).

# $rms = 0.84
# $unit = "mm"
verdict-at_check_points = Check points: { NUM($rms, digits: 2) } { $unit } rms.

# $n = 6
# $rms_mm = 0.84
verdict-at_lengths = { $n } independent { $n ->
        [one] length
        *[other] lengths
    }: { NUM($rms_mm, digits: 2) } mm rms.

verdict-no_statistics = Coordinates without standard deviations: statistics are off.

verdict-all_held = All object points and images are held.

verdict-points_held = All object points are held.

# $centre = 3.1
# $unit = "mm"
# $angle_deg = 0.012
verdict-centres = Standard deviation (mean): projection centres { NUM($centre) } { $unit }, angles { NUM($angle_deg) }°.

verdict-no_redundancy = No redundancy: the result is not checked.

# $sigma0 = 4.2
verdict-contradicting = The observations contradict each other: σ₀ = { NUM($sigma0, digits: 2) } (a priori 1). Find the cause first.

# $n = 2
verdict-faults = { $n } { $n ->
        [one] fault
        *[other] faults
    }: settle before use (see warnings).

verdict-systematic = The residuals have a systematic part, not included in these figures (see warnings).

verdict-scale_unchecked = No second length confirms the scale.

# $sigma0 = 1.4
verdict-fits_worse = Residuals are { NUM($sigma0, digits: 2) } times their a-priori values; standard deviations include this.

# $sigma0 = 0.7
verdict-fits_better = Residuals are smaller than assumed (σ₀ = { NUM($sigma0, digits: 2) }).

verdict-fits = Residuals agree with the a-priori precision.

# $images = 7
# $cameras = 1
# $points = 231
# $observations = 1530
verdict-adjusted = { $images } { $images ->
        [one] image
        *[other] images
    } of { $cameras } { $cameras ->
        [one] camera
        *[other] cameras
    }, { $points } object { $points ->
        [one] point
        *[other] points
    }, { $observations } image observations.

# $n = 4
# $kind = "distance"
verdict-observed = { $kind ->
        [control] Control points
        [check] Check points
        [distance] Scale bars
        [station] Observed projection centres
        [attitude] Observed attitudes
        [coordinate] Points of other networks
        [deviation] Deviations of single images
        [direction] Directions
        [zenith_angle] Zenith angles
        [slope_distance] Slope distances
        [difference] Coordinate differences
        [plane] Planes
        [line] Lines
        [plumb_line] Plumb lines
        [level] Levels
        *[other] Observations of kind { $kind }
    }: { $n }.

# $unknowns = 820
# $redundancy = 2310
verdict-redundancy = Unknowns: { $unknowns }. Redundancy: { $redundancy }.

verdict-datum_fixed = The observations fix position, orientation and scale.

# $which = "other"
# $parts = ["tX", "rZ"]
verdict-datum_open = Not fixed by observations: { $which ->
        [position_orientation_scale] position, orientation and scale
        [position_orientation] position and orientation
        [position_scale] position and scale
        [orientation_scale] orientation and scale
        [position] position
        [orientation] orientation
        [scale] scale
        [line] rotation about a straight line
        *[other] { LIST($parts, most: 7) } (t position, r rotation, m scale)
    }.

verdict-lengths_without_unit = Lengths have no absolute unit.

verdict-datum_by = Datum:

# $axes = "xyz"
# $a = "X"
# $b = "Y"
# $c = "Z"
# $x = 0.31
# $y = 0.42
# $z = 0.58
# $all = 0.45
# $unit = "mm"
verdict-each_axis = { $axes ->
        [xyz] { $a } { NUM($x) }, { $b } { NUM($y) }, { $c } { NUM($z) }
        [xy] { $a } { NUM($x) }, { $b } { NUM($y) }
        [z] { $c } { NUM($z) }
        *[other] rms { NUM($all) }
    } { $unit }.

verdict-not_computed = Standard deviations were not computed. Adjust again with statistics.

verdict-std_rms = Standard deviation of the object points (rms):

# $largest = 1.4
# $unit = "mm"
# $axis = "Z"
# $point = "t18"
verdict-std_largest = Largest: { NUM($largest) } { $unit } ({ $axis } of point { $point }).

verdict-std_median = Median:

# $relative = 12000
# $mean = 0.42
# $unit = "mm"
# $extent = 5.04
# $length_unit = "m"
# $share = 0.05
verdict-relative_precision = Relative precision 1 : { $relative }: mean { NUM($mean) } { $unit }, extent { NUM($extent) } { $length_unit }{ $share ->
        [0] {""}
        *[other] , without the { PERCENT($share) } % least precise
    }.

# $name = "professional"
verdict-precision_class = Class: { $name ->
        [photogrammetric] photogrammetric (1:200 000 or better)
        [professional] professional (1:100 000)
        [amateur] amateur (1:25 000)
        *[below] below amateur (1:25 000)
    }.

verdict-not_compared = Check points are not compared: the datum fixes none of their coordinates.

verdict-tested_by_lengths = No check points; independent lengths test the accuracy.

verdict-not_tested = The accuracy is not checked independently (no check points).

# $n = 4
verdict-check_points = { $n } check { $n ->
        [one] point
        *[other] points
    }, rms of adjusted minus given:

# $ratio = 1.1
# $n = 12
# $meaning = "chance"
verdict-check_ratio = That is { NUM($ratio, digits: 2) } times the expected value: { $meaning ->
        [larger] significantly more (see warnings)
        [smaller] significantly less ({ $n } values), or common errors
        *[chance] not significant ({ $n } values)
    }.

verdict-check_shift = The differences include the shift between the datum and the check points.

verdict-no_fit = No redundancy: the fit cannot be tested, and blunders cannot be detected.

# $sigma0 = 1.02
verdict-sigma0 = σ₀ = { NUM($sigma0) } (a priori 1).

verdict-fit_groups = Each group of observations has an estimated variance factor, or its a-priori precision.

verdict-fit_from_residuals = No independent test: a-priori standard deviations were estimated from these residuals.

verdict-fit_passed = Global test (5 %) passed: the residuals agree with the a-priori precision.

verdict-fit_smaller_estimated = Residuals are smaller than those of the weights: no test. Standard deviations include this.

verdict-fit_smaller = Global test (5 %): residuals are smaller than assumed. Standard deviations include this.

# $percent = 10
# $harmless = true
verdict-fit_nearly = Global test (5 %): residuals are less than { $percent } % larger than assumed. Included{ $harmless ->
        [yes] ; no practical effect.
        *[no] .
    }

verdict-fit_larger = Global test (5 %) failed: residuals are larger than assumed. Standard deviations include this.
    .why = The observations are less precise than assumed, the model is incomplete, or blunders remain.

# $kind = "control"
# $n = 12
verdict-control_held = { $kind ->
        [distance] Scale bars
        [station] Projection centres
        *[control] Control coordinates
    }: { $n } held as given, not tested by residuals.

# $kind = "control"
# $n = 12
verdict-control_unchecked = { $kind ->
        [distance] Scale bars
        [station] Projection centres
        *[control] Control coordinates
    }: { $n } observed, all required for the datum, none checked.

# $kind = "control"
# $rms = 0.31
# $largest = 0.8
# $unit = "mm"
# $n = 12
# $held = 3
verdict-control_residual = { $kind ->
        [distance] Scale bars
        [station] Projection centres
        *[control] Control coordinates
    }: rms residual { NUM($rms) }, largest { NUM($largest) } { $unit } ({ $n } observed{ $held ->
        [0] {""}
        *[other] , { $held } held
    }).

# $n = 3
verdict-rejected = { $n } image { $n ->
        [one] observation
        *[other] observations
    } rejected, listed with reasons.

verdict-none_rejected = No observation was rejected.

verdict-blunders_not_tested = Blunders were not tested.

# $n = 3
# $critical = 4.1
# $snooping = false
verdict-beyond = { $n } used image { $n ->
        [one] observation exceeds
        *[other] observations exceed
    } the critical value of { NUM($critical) } standard deviations.
    .do = { $snooping ->
            [yes] {""}
            *[no] Use data snooping ({ OPTION("reject", "snooping") }).
        }

# $critical = 4.1
verdict-none_beyond = No residual exceeds the critical value of { NUM($critical) } standard deviations.

verdict-interior_held = The interior orientation is held; standard deviations do not include its errors.

# $n = 8
verdict-interior_estimated = { $n } { $n ->
        [one] parameter
        *[other] parameters
    } of the interior orientation estimated.

# $names = ["1: K3"]
verdict-not_determinable = Not determinable: { LIST($names, most: 8) }.

# $names = ["1: P1"]
verdict-not_significant = Not significant, fixed: { LIST($names, most: 8) }.

verdict-interior_better = All are better known than a priori.

# $symbol = "K3"
# $camera = "1"
# $cameras = 2
# $px = 0.012
verdict-least_certain = Least certain: { $symbol }{ $cameras ->
        [one] {""}
        *[other] {" "}of camera { $camera }
    }, { NUM($px, digits: 2) } px standard deviation in the image.
