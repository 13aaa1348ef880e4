# $entry = "f_number"
# $value = 0.0
lens-not_positive = { $entry } = { $value } is not possible.
    .do = Give a value above 0.

# $c_mm = 50.0
# $focus_m = 0.04
lens-focus_too_near = A lens with c = { $c_mm } mm cannot be focused at { $focus_m } m.
    .do = Give a larger focus distance.
