little_redundancy = Redundanz { $redundancy }: Sigma0 ist nur auf einen Faktor { NUM($factor, digits: 2) } bekannt (Grenze { $limit }).
    .why = Standardabweichungen sind ebenso unsicher (95-%-Grenzen), und eine falsche Orientierung passt womöglich gleich gut.
    .do = Aufnahmen mit mehr Überdeckung ergänzen oder Punkte markieren.
