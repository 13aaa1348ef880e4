# $sigma0 = 2.41
# $square_sum = 102640.0
# $lower = 94179.0
# $upper = 95888.0
# $percent = 141.0
global_test = Residuals are { $sigma0 } times as large as stated (sigma0; significant at 5 %).
    .why = The stated standard deviations are too small, the model is incomplete, or blunders remain; results carry the estimated sigma0.
    .do = Check the largest residuals (square sum { NUM($square_sum, digits: 5) }, 95 % limits { NUM($lower, digits: 5) } to { NUM($upper, digits: 5) }).

# $sigma0 = 1.04
# $square_sum = 102640.0
# $lower = 94179.0
# $upper = 95888.0
# $percent = 4.0
# $limit_percent = 10.0
global_test-nearly = Residuals are { NUM($percent, digits: 2) } % larger than stated (sigma0 { $sigma0 }).
    .why = The difference is significant (square sum { NUM($square_sum, digits: 5) }, 95 % limits { NUM($lower, digits: 5) } to { NUM($upper, digits: 5) }) but below { $limit_percent } %; results carry the estimated sigma0.

# $sigma0 = 0.81
# $square_sum = 72640.0
# $lower = 94179.0
# $upper = 95888.0
# $percent = 19.0
global_test-smaller = Residuals are { NUM($percent, digits: 2) } % smaller than stated (sigma0 { $sigma0 }).
    .why = The observations are more precise than stated (square sum { NUM($square_sum, digits: 5) }, 95 % limits { NUM($lower, digits: 5) } to { NUM($upper, digits: 5) }); results carry the estimated sigma0.

# $sigma0 = 0.97
# $square_sum = 91640.0
# $lower = 94179.0
# $upper = 95888.0
# $percent = 3.0
global_test-estimated_weights = Residuals are { NUM($percent, digits: 2) } % smaller than when the weights were estimated (sigma0 { $sigma0 }).
    .why = This is no sign of higher precision (square sum { NUM($square_sum, digits: 5) }, 95 % limits { NUM($lower, digits: 5) } to { NUM($upper, digits: 5) }); results carry the estimated sigma0.
