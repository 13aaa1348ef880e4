control_suspect = { $n ->
        [one] Le point d'appui { $point } contredit
       *[other] { $n } points d'appui contredisent
     } les autres observations.

control_suspect-point = { $point } : les autres observations le déplacent de { NUM($dx, digits: 3) } ; { NUM($dy, digits: 3) } ; { NUM($dz, digits: 3) } { $unit }.

control_suspect-swayed = { LIST($names, most: 10) } n'échoue(nt) au test qu'à cause de cela.

control_suspect-unexplained = L'appui et les autres observations se contredisent, surtout en { $ids }.
