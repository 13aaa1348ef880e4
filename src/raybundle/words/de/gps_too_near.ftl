gps_too_near = Die Positionen von { $n } Aufnahmen liegen zu nah beieinander und werden nicht verwendet.
    .why = Diese Positionen bestimmen den Maßstab auf { PERCENT($scale) } % (Grenze { PERCENT($limit) } %).
    .do = Passpunkte oder eine Maßstabsstrecke angeben.
