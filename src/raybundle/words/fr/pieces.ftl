pieces-degree = Des morceaux de degré { $degree } ne sont pas possibles.

pieces-continuity = La continuité { $continuity } n'est pas possible pour des morceaux de degré { $degree }.

pieces-count = { $n } morceaux ont { $coefficients } coefficients ; 1 à { $most } sont possibles.
