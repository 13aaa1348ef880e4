marks_untested = In { $n } { $n ->
        [one] Bildmessung
       *[other] Bildmessungen
    } können Fehler bis { NUM($unseen_px, digits: 2) } px unentdeckt bleiben (Punkte: { LIST($points, most: 3) }).
    .why = Das ist mehr als das Zehnfache ihrer Standardabweichung; die anderen Bildmessungen des Punktes prüfen sie kaum.
    .do = Diese Punkte in einem weiteren Foto aus anderer Richtung messen.

marks_untested-open = { $n } { $n ->
        [one] Bildmessung ist
       *[other] Bildmessungen sind
    } nicht geprüft (Punkte: { LIST($points, most: 3) }).
    .why = Ein Fehler beliebiger Größe längs der Strahlen der anderen Bildmessungen bleibt unentdeckt.
    .do = Diese Punkte in einem weiteren Foto aus anderer Richtung messen.
