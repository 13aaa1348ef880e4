# $time_ms = 24.0
# $cameras = 1
read_out_unused = { OPTION("read_out", $time_ms) } is not used for { $cameras } { $cameras ->
        [one] camera
       *[other] cameras
    }: velocities are missing.
    .why = Velocities follow from projection centres and times.
    .do = Give photographs with exposure times, and positions, control or a scale bar.

# $camera = "p4p"
# $lacking = "times"
# $n = 2
# $least = 5
read_out_unused-camera = Camera { $camera }: { $lacking ->
        [times] its photographs have no times
        [scale] the scale is not determined
       *[velocities] photographs with a velocity: { $n }; needed: { $least }
    }.
