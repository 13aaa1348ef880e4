# $n = 1
# $independent = false
# $ids = ["d5100"]
systematic_residuals = Mean residuals over the format differ from zero ({ $n ->
        [one] camera
       *[other] cameras
     } { $ids }).
    .why = { $independent ->
        [yes] The camera model leaves a systematic part that standard deviations do not contain; in few photographs errors of single images look alike.
       *[no] The camera model leaves a systematic part in all images that standard deviations do not contain.
     }
    .do = Give a calibration, or take rolled and convergent photographs.

# $camera = "d5100"
# $cells = 12
# $tested = 80
# $rms_px = 0.05
# $share = 0.14
# $largest_px = 0.2
systematic_residuals-camera = Camera { $camera }: { $cells } of { $tested } cells, { NUM($rms_px, digits: 2) } px rms ({ PERCENT($share) } % of the residuals), at most { NUM($largest_px, digits: 2) } px.
