correlation-contained = The standard deviations of the points contain this correlation.
    .why = It matters when the calibration is used for other photographs.
