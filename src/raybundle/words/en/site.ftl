site-limit_not_finite = A limit of the space for stations is not a finite number.
    .do = Correct the limits.

# $axis = "Z"
# $low_m = 3.0
# $high_m = 1.0
site-empty = The space for stations is empty: { $axis } from { $low_m } to { $high_m } m.
    .do = Give the smaller limit first.
