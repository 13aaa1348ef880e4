qgc-no_plan = Das ist kein Plan von QGroundControl ("fileType" ist nicht "Plan").
    .do = Prüfen, ob es die richtige Datei ist.

qgc-complex_item = Das Element ist ein { $kind }; nur QGroundControl macht daraus Wegpunkte.
    .do = Es dort in einfache Elemente umwandeln.
