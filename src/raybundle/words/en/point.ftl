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
