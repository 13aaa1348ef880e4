length_test-no_length = A length test needs at least one known length.
    .do = Give a calibrated length between two measured points.

# $name = "bench"
length_test-no_scale = { $name }: no observation determines the scale, so lengths have no unit.
    .do = Give a scale bar.

# $start = "A1"
# $end = "A2"
# $length_m = 0.0
# $sigma_m = 0.001
length_test-invalid_length = Length { $start } - { $end }: { $length_m } m with standard deviation { $sigma_m } m is invalid.
    .do = Give a length above 0 between two different points, and a standard deviation of 0 or more.

# $start = "A1"
# $end = "A2"
length_test-no_error = Length { $start } - { $end } has no error because both ends are held.
    .why = It cannot test the measurement.
    .do = Leave it out.

# $start = "A1"
# $end = "A1"
length_test-same_ends = Length { $start } - { $end }: both ends are the same point.
    .do = Correct the names of the ends.

# $points = ["A7", "A9"]
# $bars = true
length_test-ends_not_measured = Ends of { $bars ->
        [yes] scale bars
       *[no] known lengths
     } that are not measured: { LIST($points, most: 10) }.
    .do = Correct the names, or measure these points.

# $ratio = 1000.2
# $likely = true
# $units = "mm for m"
# $table = true
length_test-other_unit = Known lengths are { NUM($ratio, digits: 4) } times as long as the measured ones.
    .why = Their unit or that of the scale bars is wrong{ $likely ->
        [yes] { " " }(likely { $units })
       *[no] { "" }
     }.
    .do = Give scale bars in metres{ $table ->
        [yes] ; { OPTION("unit", 0.001) } reads files in millimetres
       *[no] { "" }
     }.
