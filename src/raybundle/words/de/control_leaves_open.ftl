control_leaves_open = Nicht durch die { $kind ->
        [centres] beobachteten Projektionszentren
        [both] Passpunkte und Projektionszentren
       *[control] Passpunkte
     } bestimmt: { datum-part }.
    .why = Koordinaten haben in dieser Richtung keine Bedeutung ({ $ids }).
    .do = Mehr Passpunkte messen.

control_leaves_open-line = Die { $kind ->
        [centres] beobachteten Projektionszentren
        [both] Passpunkte und Projektionszentren
       *[control] Passpunkte
     } liegen auf einer Geraden; die Drehung um sie ist nicht bestimmt.
    .why = Koordinaten haben in dieser Richtung keine Bedeutung ({ $ids }).
    .do = Einen Passpunkt neben dieser Geraden messen.

control_leaves_open-imprecise = Die { $kind ->
        [centres] beobachteten Projektionszentren
        [both] Passpunkte und Projektionszentren
       *[control] Passpunkte
     } sind zu ungenau für die Drehung um ihre Gerade.
    .why = Die Punkte liegen { NUM($width, digits: 2) } { $unit } (rms) neben dieser Geraden, bei Standardabweichungen von { NUM($sigma, digits: 2) } { $unit } ({ $ids }).
    .do = Diese Koordinaten genauer messen, vor allem die Höhen.
