# $low = 101.2
# $high = 104.6
# $interval = 5.0
contours-none = There is no contour line at an interval of { NUM($interval, digits: 6) }.
    .why = The heights reach from { NUM($low, digits: 6) } to { NUM($high, digits: 6) }.
    .do = Choose a smaller { OPTION("interval") }.
