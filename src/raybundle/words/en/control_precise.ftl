# $ratio = 0.5
# $sigma0 = 1.4
# $wider = 2.8
control_precise = Residuals of control are { NUM($ratio, digits: 2) } times as large as stated, those of all observations { NUM($sigma0, digits: 2) } times.
    .why = Standard deviations that depend on control are up to { NUM($wider, digits: 2) } times too large.
    .do = Use { OPTION("variance_groups") }.
