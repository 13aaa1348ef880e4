maxar-no_line_times = The table of line times is empty.
    .do = Get a complete file.

# $n = 9
# $name = "EPHEMLIST"
# $announced = 10
maxar-entry_count = Entries { $name }: { $n }; NUMPOINTS is { $announced }.
    .do = Get a complete file with at least two entries.

# $entry = 7.0
# $before = 5.0
maxar-gap = Entry { NUM($entry, digits: 6) } follows entry { NUM($before, digits: 6) }: the table has a gap.
    .do = Get a complete file.

maxar-camera_backwards = The camera looks backwards: its third axis is negative.
    .do = Use the RPC of the file; this mounting is not supported.

maxar-no_band = DETECTOR_MOUNTING contains no band.
    .do = Get a complete file.

maxar-no_rigorous_model = The file contains no ephemeris, attitude and camera; only its RPC is used.

maxar-distortion_not_supported = The optical distortion is not 0, which is not supported; the rigorous model is not used.

# $angle = 0.0012
# $rms_px = 0.45
# $meets = true
# $rms_degrees_px = 812.5
maxar-radians_by_rpc = DETROTANGLE { $angle } is in radians: rigorous model minus RPC is { $rms_px } px.
    .why = { $meets ->
     [yes] In degrees it is { NUM($rms_degrees_px, digits: 4) } px.
     *[no] In degrees, no ray meets the ground.
    }

# $angle = 0.0012
# $off_px = 12.5
# $off_degrees_px = 8120.0
maxar-radians_by_axis = DETROTANGLE { $angle } is in radians: the middle of the array is { NUM($off_px, digits: 4) } px off the optical axis.
    .why = In degrees it is { NUM($off_degrees_px, digits: 4) } px off.

# $angle = 0.0012
# $apart_px = 12.5
maxar-degrees_assumed = The unit of DETROTANGLE { $angle } is not given; degrees are assumed.
    .why = In radians, image points move by up to { NUM($apart_px, digits: 4) } px, and there is no RPC to compare with.
