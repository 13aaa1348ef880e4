projective-not_metric = Keine Kamerakonstanten machen das projektive Modell metrisch.
    .do = Die Kamerakonstante einer Kamera angeben oder konvergente, teils verkantete Bilder verwenden.

projective-no_pair = Kein Bildpaar bestimmt eine Fundamentalmatrix.
    .why = Eine Fundamentalmatrix braucht { $least } gemeinsame Punkte verschiedener Tiefe.
    .do = Mehr gemeinsame Punkte messen.

projective-pair = Das Paar { $image } und { $other } hat keine Fundamentalmatrix.
