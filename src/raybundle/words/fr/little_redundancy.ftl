little_redundancy = Redondance { $redundancy } : sigma0 n'est connu qu'à un facteur { NUM($factor, digits: 2) } près (limite { $limit }).
