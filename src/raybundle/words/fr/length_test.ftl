length_test-no_length = Un contrôle de longueurs demande au moins une longueur connue.

length_test-no_scale = { $name } : aucune observation ne fixe l'échelle ; les longueurs sont sans unité.

length_test-invalid_length = Longueur { $start } - { $end } : { $length_m } m avec écart-type { $sigma_m } m n'est pas valable.

length_test-no_error = La longueur { $start } - { $end } est sans erreur : ses deux extrémités sont fixées.

length_test-same_ends = Longueur { $start } - { $end } : les deux extrémités sont le même point.

length_test-ends_not_measured = Extrémités de { $bars ->
        [yes] barres d'échelle
       *[no] longueurs connues
     } non mesurées : { LIST($points, most: 10) }.

length_test-other_unit = Les longueurs connues sont { NUM($ratio, digits: 4) } fois les longueurs mesurées.
