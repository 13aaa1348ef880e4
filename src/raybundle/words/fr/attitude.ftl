attitude-phi_right_angle = Attitude de l'image { $image } : phi = { NUM($phi_deg, decimals: 2) }° est à moins de 0,6° de 90°.

attitude-missing = Il n'y a pas d'attitudes : ni { OPTION("positions") } ni les photographies n'en ont.

attitude-other_convention = Les attitudes de { $source } ont la convention { $convention }, pas { $expected }.

attitude-no_sigma = Les attitudes de { $source } n'ont pas d'écarts-types.

attitude-no_sigma_unused = Les attitudes de { $source } ne sont pas utilisées : elles n'ont pas d'écarts-types.
