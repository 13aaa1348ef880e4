focus-calibrations_differ = The calibrations at two focuses have different models or free parameters.
    .do = Calibrate both with the same model and parameters.

# $focus_m = 3.0
# $near_m = 0.5
# $far_m = 2.0
focus-out_of_range = Focus at { $focus_m } m is outside the calibrated { $near_m } to { $far_m } m.
    .do = Calibrate at this focus.
