# $range_mm = [70.0, 24.0]
# $resolution_mm = 0.1
zoom-range = { $range_mm } mm with a resolution of { $resolution_mm } mm is not a range of focal lengths.
    .do = Give low and high above 0, in this order.

# $n = 14
# $most = 12
zoom-coefficient_count = Coefficients: { $n }; 1 to { $most } are possible.
    .do = Correct the list.
