front-title = At a glance

front-verdict = Verdict

front-client = Client

front-operator = Operator

front-object = Object

front-place = Place

front-date = Date

front-instruments = Instruments

front-rights = Rights

front-heights = Heights

front-coordinate_system = Coordinate system

# $height = false
front-asprs_statement = ASPRS statement{ $height ->
        [yes] , height
        *[no] {""}
    }

front-calibration = Calibration

# $name = "castle"
front-adjustment = Adjustment of { $name }

# $n = 2
front-faults = Do not use yet: { $n } { $n ->
        [one] fault
        *[other] faults
    } to settle.

front-no_statistics = Not checked: statistics are off, the precision is unknown.

front-no_redundancy = Not checked: there are no redundant observations.

front-contradicting = Do not use yet: the observations contradict each other.

# $grade = "weak"
front-calibration_unusable = Do not use for other photographs: the calibration is { $grade ->
        [not_determinable] not determinable
        *[weak] weak
    }.

front-not_as_required = Not as accurate as required.

# $n = 1
front-usable = Usable{ $n ->
        [0] {""}
        [one] , { $n } warning
        *[other] , { $n } warnings
    }.

front-not_judged = Requirements cannot be judged.

front-not_checked = Not checked independently (no check points).

# $n = 2
# $worst = "0.4 mm"
front-scale_checked = Scale checked by { $n } lengths (within { $worst } of each other); points not checked (no check points).

# $level = "warning"
front-severity = { $level ->
        [error] error
        [fault] fault
        [warning] warning
        [next] next
        *[note] note
    }

front-next = What to do next

# $n = 2
front-more_matters = { $n } more: see the warnings.

front-handed_over = Deliverables

# $names = ["points.csv", "map.csv"]
front-files = Files: { LIST($names, most: 15) }.

front-settled = No open matters.

front-not_kept_only = Requirements are not kept (see above); the measurement has no open matters.

# $name = "points.csv"
front-file_name = { $name }:

# $file_name = "points"
front-file = { $file_name ->
        [points] coordinates of the object points with standard deviations.
        [map] object points and stations in the coordinate system.
        [map_control] control and check points in the coordinate system.
        [coordinate_list] target coordinates with standard deviations and correlations.
        [nominal] deviations from nominal coordinates.
        [lengths] errors of known lengths.
        [images] orientations of the photographs.
        [calibration] calibrated cameras.
        [record] recording sheet.
        [check] check points.
        [control] control points.
        [block] the whole block, for a new adjustment.
        [displacements] displacements with standard deviations and verdicts.
        [velocities] velocities and accelerations of what moved.
        [surface_strain] strains of the surface.
        [epochs] dates, moved points and areas, for programs.
        *[network] network in three dimensions.
    }

# $file_name = "surface.html"
front-dense_points = Dense points of an earlier result: { $file_name }.

front-system_of_control = That of the control (no name given).

front-heights_relative = Relative: no height was given.

# $name = "DHHN2016"
# $undulation_m = 48.2
front-heights_of_geoid_value = { $name }, geoid undulation { NUM($undulation_m, digits: 6) } m.

# $name = "DHHN2016"
# $grid = "geoid.tif"
front-heights_of_grid = { $name }, geoid model { $grid }.

# $undulation_m = 48.2
front-heights_above_geoid = Above the geoid, undulation { NUM($undulation_m, digits: 6) } m.

front-heights_ellipsoidal = Above the ellipsoid.

front-heights_assumed = Not defined by the coordinate system; ellipsoidal heights assumed.

# $n = 8
front-of_given = of { $n } given

# $n = 3.5
front-rays = each in { NUM($n) } photographs (median)

# $largest_px = 0.12
front-uncertainty = Median over the format at infinity; largest { NUM($largest_px, digits: 2) } px.

# $camera = "A"
# $n = 3
front-worst_camera = Camera { $camera }, the worst of { $n }.

front-good_to = good for measurements to

front-largest_error = largest error over the format (95 % probability)

front-coverage = covered by image points of all photographs

front-median_uncertainty = uncertainty, median

front-largest_uncertainty = largest

front-uncertainty_meaning = Uncertainty of an image point due to the calibration alone, over the format, at infinity.

front-gsd = ground sample distance

# $low = 1.8
# $high = 2.4
# $unit = "cm"
front-gsd_range = median over the object points; 98 % within { NUM($low) } … { NUM($high) } { $unit }

front-flying_height = flying height

front-above_ground = above ground, median over the photographs

front-area = area

# $area = 4.2
# $unit = "ha"
front-area_of_one = in three photographs or more, within the object points; in one or more: { NUM($area) } { $unit }

# $median = false
front-std_of_coordinate = Of a coordinate, { $median ->
        [yes] median
        *[no] rms
    } over the object points:

# $mean = 0.42
# $unit = "mm"
# $extent = 5.04
# $length_unit = "m"
# $share = 0.05
front-quotient = Mean standard deviation { NUM($mean) } { $unit }, extent { NUM($extent) } { $length_unit }{ $share ->
        [0] {""}
        *[other] , without the { PERCENT($share) } % least precise points
    }.

# $n = 40
front-check_rms = Rms difference of a coordinate at { $n } check { $n ->
        [one] point
        *[other] points
    }:

front-leave_one_out = leave-one-out of control

# $n = 9
front-leave_one_out_rms = Rms difference of a coordinate at { $n } control { $n ->
        [one] point
        *[other] points
    }, each left out:

front-minus_given = d: adjusted minus given. Control took part, check points did not.

# $role = "check"
# $n = 40
# $most = 5
# $file_name = "check.csv"
front-largest_differences = The { $most } largest differences of { $n } { $role ->
        [control] control
        *[check] check
    } points; all: { $file_name }.

front-leave_one_out_row = leave-one-out of control, rms

front-leave_one_out_meaning = Leave-one-out: difference without the control point, to first order.

# $cause = "lost"
front-dash = –: { $cause ->
        [lost] not given
        [open] not compared, left open by the datum
        *[both] not given, or left open by the datum
    }.

# $role = "check"
front-role = { $role ->
        [control] control
        *[check] check
    }

# $n = 40
front-rms_of = rms of { $n }

front-held = held

front-rms = rms

front-median = median

front-quantile_95 = 95 % below

front-largest = largest

# $lengths = false
front-standard_deviations = Standard deviations of the object points. { $lengths ->
        [yes] Independent lengths: see above.
        *[no] No control and no check points: not checked independently.
    }

# $point = "t18"
# $n = 2
front-weakest_point = Largest: point { $point }, in { $n } { $n ->
        [one] photograph
        *[other] photographs
    }.

front-known_lengths = Lengths took part. Leave-one-out: length from the others minus the given one, to first order.

# $n = 3
front-more_lengths = { $n } more: distances.csv.
