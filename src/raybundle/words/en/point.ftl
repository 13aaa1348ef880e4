# $number = "-3"
point-number_invalid = { $number } is not a usable number of a point.
    .do = Export the file again.

# $point = "A1"
# $sigma = "sX"
# $coordinate = "X"
point-sigma_without_coordinate = Point { $point } has { $sigma }, but no { $coordinate }.
    .do = Give the coordinate, or leave { $sigma } empty.

# $point = "A1"
point-tie_with_sigma = Tie point { $point } has a standard deviation.
    .do = Change its role to control, or leave the standard deviation empty.

# $point = "A1"
point-control_without_sigma = Control point { $point } has no coordinate with a standard deviation.
    .do = Give one (0 = fixed), or change its role to tie.

# $point = "A1"
point-check_without_coordinate = Check point { $point } has no coordinate.
    .do = Give one, or change its role to tie.

# $point = "P7"
# $axis = "X"
# $sigma = -0.1
point-sigma_out_of_range = Point { $point }, { $axis }: { $sigma } is no standard deviation.
    .do = Give 0 (held), a number above 0, or NaN for an approximate coordinate.

# $point = "P7"
# $axis = "X"
# $sigma = 0.1
point-no_coordinate = Control point { $point } has a standard deviation ({ $sigma }) but no coordinate { $axis }.
    .do = Give the coordinate, or NaN for its standard deviation.

# $names = ["A", "B"]
point-not_in_result = Not in the result, or without coordinates: { $names }.
    .do = Give points of the result.

# $point = "P7"
# $window = 4.0
# $extent = 2.0
point-window_too_large = The window { NUM($window, digits: 6) } of point { $point } is larger than the extent of all points, { NUM($extent, digits: 6) }.
    .do = Give it in the unit of the coordinates.
