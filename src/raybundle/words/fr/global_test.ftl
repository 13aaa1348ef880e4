global_test = Les résidus sont { $sigma0 } fois plus grands qu'annoncé (sigma0).

global_test-nearly = Les résidus sont { NUM($percent, digits: 2) } % plus grands qu'annoncé (sigma0 { $sigma0 }).

global_test-smaller = Les résidus sont { NUM($percent, digits: 2) } % plus petits qu'annoncé (sigma0 { $sigma0 }).

global_test-estimated_weights = Les résidus sont { NUM($percent, digits: 2) } % plus petits que lors de l'estimation des poids (sigma0 { $sigma0 }).
