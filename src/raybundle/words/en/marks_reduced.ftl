# $table = "control.csv"
# $side_px = 1200.0
# $sigma_px = 4.0
# $exact = false
# $full_px = 6000.0
# $factor = 5.0
# $before_px = 800.0
# $after_px = 1.2
# $marks = 12
# $ids = ["control.csv"]
marks_reduced = The { $marks } measurements of { $table } were made in copies of { NUM($side_px, digits: 5) } px{ $exact ->
     [yes] { "" }
     *[no] { "" } (± { NUM($sigma_px, digits: 2) } px)
    }, not { NUM($full_px, digits: 5) } px.
    .why = As given they deviate by { NUM($before_px, decimals: 0) } px; with the factor { NUM($factor, digits: 4) }, which is applied, by { NUM($after_px, digits: 2) } px (median).
    .do = Measure in the photographs at full size.
