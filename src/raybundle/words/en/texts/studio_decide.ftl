studio_decide-parts = Decisions

studio_decide-run = Run
    .title = Show the run of all stages

studio_decide-options = Options
    .title = Show the options of the adjustment

studio_decide-parameters = Parameters
    .title = Show the parameters of the cameras

studio_decide-select = Select
    .title = Select image observations by a limit

studio_decide-compare = Compare
    .title = Compare adjustments

studio_decide-calibration = Calibration
    .title = Show the quality of the calibration

studio_decide-targets = Targets
    .title = Show the targets of the photographs

studio_decide-command = The same on the command line

studio_decide-reset = Defaults
    .title = Set all to their defaults

studio_decide-adjust = Adjust with these options
    .title = Adjust the block with the marks in the background

studio_decide-options_note = The options hold for every adjustment begun in this studio.
    .why = The line below shows the progress; Stop ends the adjustment and changes nothing.

studio_decide-options_stored = Options of the next adjustment stored.

studio_decide-parameters_note = auto: by block and options; free and held take precedence over both.
    .why = A choice is an action of the journal that can be undone; it holds from the next adjustment on.

# $n = 40
# $of = 52
studio_decide-interiors_shown = { $n } of { $of } interior orientations are shown.

# $camera = "d5100"
studio_decide-camera = Camera { $camera }

# $camera = "d5100"
# $image = "a.jpg"
studio_decide-camera_image = Camera { $camera }, image { $image }

# $name = "d5100"
studio_decide-parameters_of = Parameters of { $name }

studio_decide-joint_tests = Joint tests of groups

# $group = "K1, K2"
# $F = "3.1"
# $p = "0.02"
studio_decide-joint_test = { $group }: F { $F }, p { $p }

studio_decide-next = next
    .title = In the next adjustments

studio_decide-last_status = status
    .title = In the last adjustment

studio_decide-sigma = sigma
    .title = Standard deviation a posteriori

studio_decide-t = t
    .title = Value over its standard deviation; for an additional parameter, its significance

studio_decide-p = p
    .title = Probability of a larger |t| by chance: small means significant

studio_decide-effect = effect [px]
    .title = Largest shift within the format caused by the value

studio_decide-effect_sigma = ± [px]
    .title = The same for one standard deviation

studio_decide-correlation = correlation
    .title = The largest, with another parameter or with the exterior orientation

# $other = "P1"
studio_decide-correlated = correlated with { $other }

studio_decide-exterior = exterior orientation

# $strong = 0.95
studio_decide-strong = Above { $strong }: the two are hardly separable

# $status = "not_significant"
studio_decide-status = { $status ->
        [held] held
        [estimated] estimated
        [observed] observed
        [not_significant] not significant
        [not_determinable] not determinable
        [not_adjusted] not adjusted
        *[other] { $status }
    }

# $choice = "free"
studio_decide-choice = { $choice ->
        [free] free
        [held] held
        *[auto] auto
    }

# $symbol = "K3"
# $camera = "d5100"
studio_decide-choice_of = { $symbol } of camera { $camera } in the next adjustments

# $symbol = "K3"
# $camera = "d5100"
# $choice = "held"
studio_decide-choice_stored = { $symbol } of { $camera }: { studio_decide-choice } from the next adjustment on.

studio_decide-limit = limit

studio_decide-observations_by = Image observations by

studio_decide-beyond = Observations beyond the limit

# $quantity = "w"
studio_decide-quantity = { $quantity ->
        [w] |w|
        [sigma] sigma XYZ
        [rays] rays
        *[redundancy] redundancy number
    }

# $quantity = "w"
studio_decide-quantity_meaning = { $quantity ->
        [w] Largest |w| of an image observation.
        [sigma] Largest standard deviation of X, Y, Z of a tie point.
        [rays] Rays of a tie point that are used.
        *[redundancy] Smaller redundancy number of an image observation.
    }

# $low = "0.1"
# $high = "5.2"
# $middle = "0.8"
studio_decide-range = Range { $low } to { $high }, median { $middle }.

studio_decide-no_range = Unknown: the adjustment has no statistics.

# $side = "above"
studio_decide-selected = { $side ->
        [above] Values above the limit are selected.
        *[below] Values below the limit are selected.
    }

# $n = 12
# $points = 9
# $percent = "0.4"
# $used = 3000
studio_decide-counts = { $n } image { $n ->
        [one] observation
        *[other] observations
    } of { $points } { $points ->
        [one] point
        *[other] points
    } beyond it: { $percent } % of { $used }.

# $n = 2
studio_decide-marks_beyond = { $n } { $n ->
        [one] mark
        *[other] marks
    } beyond the limit; marks are not rejected here.
    .do = Move or remove them.

# $n = 40
# $drawn = "some"
studio_decide-more = and { $n } more{ $drawn ->
        [some] ; not all are drawn
        *[all] {""}
    }

studio_decide-reject_all = Reject all
    .title = Reject them in one action; one undo restores them

# $limit = "4"
# $quantity = "w"
studio_decide-rejected = Rejected: beyond { $limit } in { studio_decide-quantity }.
    .do = Adjust again.

studio_decide-show_in_images = Show in images
    .title = Draw rings around the selected image points

studio_decide-show_in_space = Show in space
    .title = Show the selected object points

studio_decide-draw = draw in images and space

# $point = "t17"
# $image = "a.jpg"
studio_decide-point_in_image = { $point } in { $image }

# $point = "t17"
# $image = "a.jpg"
studio_decide-show_point = Show { $point } in { $image }

studio_decide-adjustments = Adjustments of this session

studio_decide-adjustment = adjustment

studio_decide-first = first

studio_decide-second = second

# $name = "1"
# $side = "first"
studio_decide-as_side = { $name } as the { $side ->
        [first] first
        *[second] second
    }

studio_decide-sigma0 = sigma0

studio_decide-free = free
    .title = Number of estimated parameters

studio_decide-mean_sigma = mean sigma

studio_decide-rms_check = rms at check points

studio_decide-defaults = default options

studio_decide-adjust_again = Adjust again with another option or parameter to compare.

studio_decide-choose_two = Choose two different adjustments.

studio_decide-comparison = Comparison of the two adjustments

# $name = "1"
studio_decide-largest_residuals = Largest residuals of { $name }

studio_decide-v = v [px]

# $origin = "opened"
studio_decide-origin = { $origin ->
        [opened] initial result
        [before] measured before
        [oriented] oriented here
        [calibrated] calibrated here
        [elsewhere] written by another program
        *[adjusted] adjusted here
    }

studio_decide-of_adjustment = of adjustment

studio_decide-report = Report of the adjustment

studio_decide-not_adjusted = Nothing is adjusted yet: press Adjust.

studio_decide-no_report = This result has no report: press Adjust to write one.

studio_decide-window = Open in a window

studio_decide-network = Network in three dimensions

studio_decide-judging = Computing the quality of the calibration …

studio_decide-wait = There is no adjustment yet.
    .do = Wait for its end.

studio_decide-no_interior = No camera has an adjusted interior orientation of its own.

studio_decide-no_verdict = No parameter is estimated: there is no verdict.

# $source = "computed"
studio_decide-verdict_source = { $source ->
        [stored] By raybundle calibrate, with cross-validation.
        *[computed] From the last adjustment, without cross-validation (raybundle calibrate adds it).
    }

studio_decide-weaknesses = Weaknesses

studio_decide-next_photographs = Next photographs

# $camera = "d5100"
studio_decide-next_photographs_of = Next photographs with camera { $camera }

studio_decide-uncertainty_then = uncertainty then [px]

studio_decide-smaller_by = smaller by

# $now_px = "0.3"
studio_decide-next_photographs_note = Largest uncertainty of projection over the format, now { $now_px } px.
    .why = Each row counts this photograph and those before it.
    .do = Take them and run again.

studio_decide-no_next_photographs = Four further photographs improve it by less than a tenth.

studio_decide-determinability = determinability

studio_decide-largest_uncertainty = largest uncertainty of projection

studio_decide-median_uncertainty = its median over the format

studio_decide-image_sigma = image points

studio_decide-coverage = format covered

studio_decide-reach = reach towards the corners

studio_decide-quarter_turns = quarter turns about the axis

studio_decide-convergence = axes within, of their mean

# $rms_px = "0.2"
# $fit_px = "0.15"
studio_decide-cross_validation = { $rms_px } px left out, { $fit_px } px in the fit

# $model = "brown"
# $width_px = 4928
# $height_px = 3264
# $pixel_um = 4.78
studio_decide-about = Model { $model }, { $width_px } × { $height_px } px, pixel { NUM($pixel_um, digits: 4) } µm

studio_decide-coverage_caption = Used image points of all photographs, in each cell of the format.

# $camera = "d5100"
studio_decide-coverage_of = image points of camera { $camera } over the format
