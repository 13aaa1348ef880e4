mrcal-no_dictionary = Das ist keine .cameramodel-Datei; ihr fehlt das Dictionary.
    .do = Prüfen, ob es die richtige Datei ist.
