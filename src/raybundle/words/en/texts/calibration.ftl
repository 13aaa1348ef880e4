# $infinity = false
# $distance = 5.0
# $turn_deg = 0.0123
# $rms_px = 0.21
# $largest_px = 0.8
calibration-difference = Difference { $infinity ->
        [yes] at infinity
        *[no] at distance { $distance }
    } after a rotation of { NUM($turn_deg, decimals: 4) } deg: rms { $rms_px } px, largest { $largest_px } px.

# $expected_px = 0.2
# $ratio = 1.1
# $same = true
calibration-expected = Expected by the covariances: { $expected_px } px. The difference is { NUM($ratio, decimals: 1) } times that{ $same ->
        [yes] {""}
        *[no] : not one camera in one state
    }.

calibration-parts = Largest difference [px] in 3 x 3 parts of the format:

# $camera = "left"
# $model = "opencv"
# $exact = false
# $rms_px = 0.004
# $largest_px = 0.02
calibration-converted = Camera { $camera }: { $model }, { $exact ->
        [yes] exact
        *[no] fitted over the format, rms { $rms_px } px, largest { $largest_px } px
    }.

# $key = "maker-model-28mm"
calibration-stored = Stored in the camera library: { $key }.

# $n = 3
# $folder = "cameras"
calibration-library = { $n } { $n ->
        [one] calibration
        *[other] calibrations
    } in { $folder }:

# $key = "maker-28mm"
# $width_px = 6000
# $height_px = 4000
# $model = "brown"
# $date = "2026-05-01"
# $source = "adjustment"
# $photographs = 24
# $sigma0 = 1.02
# $grade = "good"
calibration-entry = { $key }; { $width_px } x { $height_px } px, { $model }; { $date }, { $source }{ $photographs ->
        [0] {""}
        [one] , 1 photograph
        *[other] , { $photographs } photographs
    }{ $sigma0 ->
        [0] {""}
        *[other] , sigma0 { $sigma0 }
    }{ $grade ->
        [none] {""}
        *[other] , { $grade }
    }

# $name = "DSC_0001.JPG"
# $key = "maker-model-28mm"
# $width_px = 6000
# $height_px = 4000
calibration-photograph = { $name }: { $key }; { $width_px } x { $height_px } px.

# $name = "maker-model-28mm"
# $fits = true
# $reasons = "maker model; EXIF focal length 28 mm"
calibration-match = { $fits ->
        [yes] fits
        *[no] no
    }: { $name }: { $reasons }

# $n = 3
calibration-completed = { $n } { $n ->
        [one] target
        *[other] targets
    } completed by prediction.

# $n = 12
calibration-dots = { $n } { $n ->
        [one] dot
        *[other] dots
    } without a code.
