in_parts = Die Normalgleichungen wurden in { $parts } Teilen reduziert (Helmert-Wolf).
    .why = In einem Stück benötigen sie { $needed_gb } GB; { OPTION("memory") } erlaubt { $allowed_gb } GB. Das Ergebnis ist bis auf Rundung dasselbe.

in_parts-least = Die Normalgleichungen wurden in { $parts } Teilen reduziert (Helmert-Wolf) und benötigen noch etwa { $least_gb } GB.
    .why = In einem Stück benötigen sie { $needed_gb } GB; { OPTION("memory") } erlaubt { $allowed_gb } GB. Das Ergebnis ist bis auf Rundung dasselbe.
    .do = Ist der Speicher nicht vorhanden, weniger Bildpunkte verwenden.

in_parts-cluster = Die Normalgleichungen wurden in { $parts } Teilen von Rechnern eines Clusters reduziert (Helmert-Wolf).
    .why = Das Ergebnis ist bis auf Rundung dasselbe.
