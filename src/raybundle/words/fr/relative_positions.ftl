relative_positions = Les positions s'accordent entre elles mieux que ne l'indiquent leurs écarts-types.

relative_positions-direction = { $direction ->
     [plan] En plan
     *[height] En altitude
    } : { NUM($sigma_m, digits: 2) } m, donné ou supposé { NUM($stated_m, digits: 2) } m
