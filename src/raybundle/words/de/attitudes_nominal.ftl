attitudes_nominal = Die Drehung des Blocks um die Linie seiner Positionen beruht allein auf den Lagewinkeln.
    .why = Der Einbau der Kamera ist auf { $sigma_deg }° wie angegeben angenommen.
    .do = Einen Querstreifen fliegen oder Passpunkte angeben.
