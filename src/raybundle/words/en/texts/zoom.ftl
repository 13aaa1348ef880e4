# $n = 4
# $low_mm = 24.2
# $high_mm = 68.3
# $resolution_mm = 0.1
zoom-settings = Zoom lens: { $n } settings from { $low_mm } to { $high_mm } mm, focal lengths { $resolution_mm ->
        [0] not rounded
        *[other] rounded to { $resolution_mm } mm
    }.

# $factor = 1.2
zoom-scatter = Scatter about the curves: { NUM($factor, decimals: 2) } times the variances of the calibrations.

# $symbol = "c"
# $order = 2
# $variable = "f"
# $largest = 0.01
zoom-curve = { $symbol }: order { $order } in { $variable }, largest residual { NUM($largest, digits: 2) }.

# $of = "calibration"
zoom-focus_unknown = The focus of the { $of ->
        [calibration] calibration
        *[photograph] photograph
    } is not known, nor its effect on the calibration.

# $focus_m = 2.0
# $calibrated_m = 5.0
# $change_mm = 0.1234
zoom-refocused = Focused at { NUM($focus_m, digits: 6) } m, calibrated at { NUM($calibrated_m, digits: 6) } m: c is changed by { NUM($change_mm, decimals: 4) } mm (lens equation).
    .why = The change of distortion is not known.
    .do = Calibrate a second focus.
