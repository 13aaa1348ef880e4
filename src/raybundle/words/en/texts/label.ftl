# $n = 300
# $of = 1200
label-rows_shown = { $n } of { $of } rows are shown.

# $n = 300
# $of = 1200
# $rest = "points.csv"
label-rows_shown_of = { $n } of { $of } rows are shown; all are in { $rest }.

label-quantity = quantity

label-value = value

label-camera = camera

label-symbol = symbol

label-unit = unit

label-sigma = sigma

label-ratio = ratio
