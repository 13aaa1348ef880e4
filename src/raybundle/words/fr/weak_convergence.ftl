weak_convergence = Pas de convergence : pas de { NUM($step_sigmas, digits: 1) } écarts-types après { $iterations } itérations.
