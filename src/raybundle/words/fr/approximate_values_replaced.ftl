approximate_values_replaced-points = { $n } points de liaison étaient loin des rayons et ont été recalculés : { $ids }.

approximate_values_replaced-unsolvable = Les valeurs approchées du bloc ne mènent à aucune solution et ont été remplacées (sigma0 { $sigma0 }).

approximate_values_replaced-poor = Les valeurs approchées du bloc mènent à sigma0 { $given_sigma0 } et ont été remplacées (sigma0 { $sigma0 }).

approximate_values_replaced-behind = Les valeurs approchées mènent à { $n } points image derrière des caméras et ont été remplacées (sigma0 { $sigma0 }).
