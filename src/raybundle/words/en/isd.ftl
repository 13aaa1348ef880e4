isd-map_projected = The image is projected onto a map; its rows are not the lines of the scan.
    .do = Give the image as it was taken, with a description without projection.

isd-line_times = The table of line times is not monotonic.
    .do = Correct it: lines must increase, and times per line must have one sign and not be 0.

# $line_number = 1200.5
# $time_s = 12.5
# $off_lines = 30.2
# $before_s = 10.0
# $step_s = 0.002
isd-line_times_contradict = Line { NUM($line_number, digits: 6) } starts { NUM($off_lines, decimals: 1) } line times off the preceding lines.
    .why = It starts at { NUM($time_s, digits: 6) } s, those before at { NUM($before_s, digits: 6) } s with { NUM($step_s, digits: 6) } s per line.
    .do = Write the description again with a current version of ALE.

isd-focal_plane = The transformation from focal plane to pixels has no inverse.
    .do = Correct focal2pixel_lines and focal2pixel_samples.

# $n = 6
# $most = 5
isd-coefficient_count = Coefficients of the distortion: { $n }; at most { $most } are possible.
    .do = Delete the surplus coefficients.

# $coefficients = [0.1, 0.02]
# $radius_mm = 3.2
# $detector_mm = 20.0
# $factor = -1.5
isd-distortion_folds = The distortion ({ $coefficients }) folds the focal plane at { $radius_mm } mm from the axis.
    .why = The detector reaches { $detector_mm } mm, which the coefficients multiply by { $factor }; they have other units or belong to another camera.
    .do = Get a description with the right coefficients.

# $coefficient = 0.01
# $detector_mm = 20.0
isd-distortion_folds_detector = The coefficient { $coefficient } folds a detector that reaches { $detector_mm } mm from its middle.
    .do = Get a description with the right coefficient.

# $n = 3
# $coefficients = [0.1, 0.02, 0.0]
isd-distortion_no_inverse = The distortion{ $n ->
     [0] { "" }
     *[other] { " " }({ $coefficients })
    } has no inverse over the detector.
    .do = Get a description with the coefficients of this detector.

# $distance_m = 1787.4
# $radius_m = 1737400.0
isd-position_inside_body = A position is { NUM($distance_m, digits: 6) } m from the centre of a body of radius { NUM($radius_m, digits: 6) } m.
    .do = Correct the units of positions and radii.

# $n = 9
# $entries = 10
isd-time_count = The table has { $n } times for { $entries } entries.
    .do = Get a complete file.

# $entry = 3
# $time_s = 12.5
# $before_s = 13.0
isd-time_order = Entry { $entry }: time { NUM($time_s, digits: 6) } s follows { NUM($before_s, digits: 6) } s.
    .do = Sort the entries by time and delete repeated times.

# $n = 0
isd-quaternion_zero = { $n ->
     [0] There are no quaternions.
     *[other] A quaternion has length 0.
    }
    .do = Get a complete file.

# $n = 9
# $positions = 10
isd-velocity_count = The table has { $n } velocities for { $positions } positions.
    .do = Get a complete file.

# $n = 2
# $names = ["camera", "image"]
isd-no_model = This JSON is no description of the Community Sensor Model: name_model is missing.
    .why = { $n ->
     [0] It has no keys.
     *[other] Its keys are { LIST($names, most: 6) }.
    }
    .do = Give the description that ALE writes for the image (isd_generate).

# $model = "'USGS_ASTRO_PROJECTED_SENSOR_MODEL'"
isd-model_unknown = { $model } is no sensor model that is read.
    .why = Line scanners, push-frame cameras, frames and radars are read (..._LINE_SCANNER_, _PUSH_FRAME_, _FRAME_ and _SAR_SENSOR_MODEL).
    .do = Give a scene of one of these, or an RPC of this one.

isd-no_aberration = Neither aberration nor refraction is applied, as in USGSCSM.

# $distance_km = 1837.4
# $radius_km = 1737.4
isd-kilometres_assumed = The unit of the positions is not given; kilometres are assumed, as ALE writes them.
    .why = The sensor is { NUM($distance_km, digits: 6) } km from the centre of a body of radius { NUM($radius_km, digits: 6) } km.

isd-detector_turned = The third axis of the detector points away from the body; it is reversed, as in USGSCSM.

# $lines = [1200, 4800]
isd-scan_reverses = The scan reverses at line { LIST($lines, most: 6) }; the ground there is seen twice.
    .why = A ground point there has two image points; the one nearer to the start of the projection is computed.

# $name = "'legendre'"
# $incomplete = false
# $known = ["radial", "radtan"]
isd-distortion_unknown = The optical distortion { $name } is not supported.
    .why = { $incomplete ->
     [yes] ISIS corrects it by further coefficients, which the description does not contain.
     *[no] Supported are { LIST($known, most: 12) }.
    }
    .do = Use an RPC of the scene instead.

# $n = 2
# $steps = 12.5
# $from_s = 3.125
# $to_s = 4.5
# $error_px = 2.5
# $measured = true
# $limit_px = 1.0
isd-attitude_gap = The attitudes have { $n } { $n ->
     [one] gap
     *[other] gaps
    }, the widest of { NUM($steps, decimals: 1) } steps from { NUM($from_s, decimals: 3) } to { NUM($to_s, decimals: 3) } s.
    .why = { $measured ->
     [yes] Within such a time, the attitude deviates by { NUM($error_px, decimals: 2) } px rms from interpolation (limit { $limit_px } px).
     *[no] The table is too short to estimate the error of interpolation.
    }
    .do = Get a complete table.

# $n = 2
# $steps = 12.5
# $from_s = 3.125
# $to_s = 4.5
# $error_px = 0.12
isd-attitude_gap_bridged = { $n } { $n ->
     [one] gap
     *[other] gaps
    } of the attitudes interpolated, the widest of { NUM($steps, decimals: 1) } steps from { NUM($from_s, decimals: 3) } to { NUM($to_s, decimals: 3) } s.
    .why = Within such a time, the attitude deviates by { NUM($error_px, decimals: 3) } px rms from interpolation.

# $height = 0.0
# $lines = 360
# $delay_s = 0.1
# $overlap = 1.0
isd-framelets = Framelets of { NUM($height, digits: 4) } lines every { NUM($delay_s, digits: 4) } s, { NUM($overlap, digits: 3) } lines of them overlapping, do not fill an image of { $lines } lines.
    .do = Correct framelet_height, interframe_delay or num_lines_overlap (an even number).
