control_precise = Verbesserungen der Passpunkte sind { NUM($ratio, digits: 2) }-mal so groß wie angegeben, die aller Beobachtungen { NUM($sigma0, digits: 2) }-mal.
    .why = Standardabweichungen, die von Passpunkten abhängen, sind bis zu { NUM($wider, digits: 2) }-mal zu groß.
    .do = { OPTION("variance_groups") } verwenden.
