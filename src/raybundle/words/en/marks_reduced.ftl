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
marks_reduced = The { $marks } measurements of { $table } were made in copies of { NUM($side_px, digits: 5) } px, not { NUM($full_px, digits: 5) } px{ $exact ->
     [yes] { "" }
     *[no] { "" } (± { NUM($sigma_px, digits: 2) } px)
    }.
    .why = As given they are { NUM($before_px, decimals: 0) } px apart, times { NUM($factor, digits: 4) } { NUM($after_px, digits: 2) } px; this factor is applied, to their standard deviations too.
    .do = Measure in the photographs at full size.
