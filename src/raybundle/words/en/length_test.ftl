length_test-no_length = A length test needs at least one known length.

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
