redundancy_sum = Die Redundanzanteile ergeben { NUM($sum, decimals: 6) } statt { $redundancy } (Grenze { NUM($limit, digits: 2) }).
    .why = Die Standardabweichungen sind nicht verlässlich.
    .do = Diesen Block als Programmfehler melden.
