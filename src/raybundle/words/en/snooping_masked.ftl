# $rejected = 200
# $sigma0 = 14.0
# $ratio = 9.0
snooping_masked = Blunders may mask one another: sigma0 is still { $sigma0 } after { $rejected } rejections.
    .why = That is { NUM($ratio, digits: 2) } times the scale of the median residual, and no single test value is significant.
    .do = Check point numbers, approximate values and the standard deviations of the image points.
