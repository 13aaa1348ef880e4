# $step_sigmas = 0.02
# $iterations = 50
weak_convergence = No convergence: steps still have { NUM($step_sigmas, digits: 1) } standard deviations after { $iterations } iterations.
    .why = Some unknown is hardly determined.
    .do = Check which standard deviations are large, and add observations there.
