marks_untested = { $n } { $n ->
        [one] Bildmessung ist
       *[other] Bildmessungen sind
    } nicht geprüft (Punkte: { LIST($points, most: 3) }).
    .why = Ein Fehler von zehn Standardabweichungen einer solchen Bildmessung kann unentdeckt bleiben.
    .do = Diese Punkte in einem weiteren Foto aus anderer Richtung messen.
