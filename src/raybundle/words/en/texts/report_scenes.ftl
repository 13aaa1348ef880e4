report_scenes-title = Satellite scenes

report_scenes-strips_title = Strips of line scanners

# $n = 2
report_scenes-scenes = { $n } { $n ->
        [one] scene
        *[other] scenes
    } with the geometry of the vendor.
    .why = The table lists the corrections of the adjustment.

report_scenes-bias = A bias is added to the projection, in pixels of the scene.

report_scenes-maps = Maps and figures of the network show a scene near its ground, in its viewing direction.

report_scenes-sigma_of_scenes = Stated sigma: known before the adjustment, as the vendor's ERR_BIAS.

report_scenes-marked = Marked: more than three times the stated sigma.
    .do = Check the file, the control and its coordinate system.

# $n = 2
report_scenes-strips = { $n } { $n ->
        [one] strip
        *[other] strips
    } of line scanners with lines positioned by GNSS and INS.

report_scenes-corrections = Corrections of the adjustment: along track, across track, in height, and about the axes of the line.

report_scenes-further_parameters = Where estimated, the offset of the clocks and the lever arm follow.

report_scenes-sigma_of_strips = Stated sigma: of positions and attitudes in their table; –: unknown, as INS misalignment.

report_scenes-every_parameter = Every parameter

# $kind = "scene"
# $name = "forward"
report_scenes-name = { $kind ->
        [strip] Strip
        *[scene] Scene
    } { $name }

# $kind = "scene"
report_scenes-kind = { $kind ->
        [strip] strip
        *[scene] scene
    }

# $n = 6
# $of = 20
# $kind = "scene"
report_scenes-figures_drawn = Figures are drawn for { $n } of { $of } { $kind ->
        [strip] strips
        *[scene] scenes
    }.

report_scenes-on_ground = on the ground

report_scenes-value_by_sigma = value / stated sigma

# $strip = false
report_scenes-model = { $strip ->
        [yes] GNSS and INS
        *[no] orbit and attitude
    }

report_scenes-range_doppler = orbit, range and Doppler

report_scenes-along_track = along track

# $level = 0.001
report_scenes-trend = The mean residual changes with the line (probability by chance below { PERCENT($level) } %):

# $name = "forward"
# $axis = "x"
# $size_px = 0.4
report_scenes-wave = { $name } in { $axis } by up to { NUM($size_px, digits: 2) } px.

# $n = 3
report_scenes-more_waves = { $n } more.

# $kind = "scene"
report_scenes-cause = { $kind ->
        [scene] Possible causes: jitter of the attitude, or a drift that the bias lacks.
        *[strip] Possible cause: movements of the aircraft between the fixes.
    }
    .do = { $kind ->
            [scene] Choose the bias “drift”, or a curve for a rigorous scene.
            *[strip] Estimate more fixes.
        }

report_scenes-no_trend = No mean residual changes significantly with the line: no jitter is visible.

report_scenes-hidden = not visible

# $kind = "scene"
report_scenes-two_rays = Most points are in two { $kind ->
        [strip] strips
        *[scene] scenes
    } only.
    .why = An error in the plane of their two rays changes heights and leaves no residual.

report_scenes-jitter_in_heights = Jitter along the track of a stereo pair is therefore visible in part only.

# $rms_px = 0.31
# $length_px = 0.5
# $drawn_px = 40
report_scenes-residuals = Residuals, rms { $rms_px } px; vectors: { NUM($length_px, digits: 1) } px is drawn as { $drawn_px } px of this page.

# $constant = true
report_scenes-bias_map = Bias over the scene, { $constant ->
        [yes] constant
        *[no] variable
    }; it is added to the projection of the RPC.
    .why = The dot is the start of a vector.

# $axis = "x"
report_scenes-track = Residuals in { $axis } along the track and their running mean; band: 95 % without trend.

report_scenes-no_jitter_plot = No RPC can replace this scene, and no jitter is drawn:

# $limit_px = 0.001
report_scenes-no_jitter = The adjusted rigorous model contains no jitter: an RPC agrees with it within { $limit_px } px (rms).

# $x_px = 0.12
# $y_px = 0.31
report_scenes-jitter = Rigorous model minus its RPC, mean over the columns: rms { NUM($x_px, digits: 2) } px in x, { NUM($y_px, digits: 2) } px in y.
    .why = An RPC is too smooth for jitter; these are its remaining errors.

# $quantity = "height"
# $mean = 12.1
# $known = true
# $sigma = 0.4
# $largest = 3.1
# $unit = "mm"
# $banded = true
report_scenes-correction = Correction of the { $quantity ->
        [position_along_track] position along track
        [position_across_track] position across track
        [height] height
        [attitude_about_x] attitude about x
        [attitude_about_y] attitude about y
        *[attitude_about_z] attitude about z
    }: at most { NUM($largest, digits: 2) } { $unit } from its mean.
    .why = Mean: { NUM($mean, digits: 5) }{ $known ->
            [yes] {" "}± { NUM($sigma, digits: 2) }
            *[no] {""}
        } { $unit }{ $banded ->
            [yes] ; band: 1 sigma.
            *[no] .
        }

report_scenes-push_frame = push-frame

report_scenes-optical_bar = optical bar
