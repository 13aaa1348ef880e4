positions_assumed = { $n } position(s) sans écart-type ; { $plan_m } m en plan et { $height_m } m en altitude sont supposés.
