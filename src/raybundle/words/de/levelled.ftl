levelled = Die Höhen der Passpunkte sind unbekannt: Der Block ist nach seiner Blickrichtung auf etwa { NUM($angle_deg, decimals: 0) }° horizontiert.
    .why = Höhen sind relativ und können um diesen Winkel geneigt sein; sie sind mit { $sigma_m } m beobachtet.
    .do = Die Höhen von drei Passpunkten angeben.
