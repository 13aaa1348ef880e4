# $low = 101.2
# $high = 104.6
# $interval = 5.0
contours-none = There is no contour line at an interval of { NUM($interval, digits: 6) }.
    .why = The heights reach from { NUM($low, digits: 6) } to { NUM($high, digits: 6) }.
    .do = Choose a smaller { OPTION("interval") }.

# $interval = 0.01
# $sigma = 0.008
# $unit = "m"
contours-interval_too_small = The interval { $interval } { $unit } is less than two standard deviations of a height ({ NUM($sigma, digits: 2) } { $unit }).
    .why = Neighbouring lines are not distinguishable.
    .do = Choose a larger interval.
