# $n = 1
# $most = 32
orientation_fix-count = Number of orientation fixes: { $n }.
    .do = Give from 2 to { $most } fixes.

# $earlier = 3
# $later = 4
orientation_fix-time_order = The time of orientation fix { $later } is not after that of fix { $earlier }.
    .do = Sort the fixes by time.

orientation_fix-outside_image = All orientation fixes are before the first image line or after the last.
    .do = Give fixes at times within the image.
