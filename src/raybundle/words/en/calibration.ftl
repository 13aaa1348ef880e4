# $value = "'a'"
calibration-no_list = { $value } is not a list of calibrated parameters.
    .do = Give a list of tables with parameter, value, sigma and correlations.

# $number = 2
calibration-incomplete_entry = Entry { $number } is not a calibrated parameter.
    .do = Give parameter, value, sigma and, as a list, correlations with the entries before it.

# $number = 3
# $n = 1
# $needed = 2
calibration-correlation_count = Entry { $number } has { $n } correlations; { $needed } are needed, with the parameters before it.
    .do = Complete the list.

calibration-not_positive_definite = The correlations do not form a positive definite matrix.
    .do = Correct them, or write more digits.
