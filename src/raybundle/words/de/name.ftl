name-unprintable = { $name } ist kein druckbarer Name.
    .do = Den Namen ändern.

name-twice = { $kind ->
        [camera] Die Kamera
        [image] Das Bild
        [point] Der Punkt
        [rig] Das Rig
       *[other] Der Name
     } { $name } kommt zweimal vor.
    .do = Eine der beiden Angaben löschen oder umbenennen.

name-missing = Der Name fehlt.
    .do = Den Namen in der Zeile ergänzen.

name-blanks = { $name } ist leer oder hat Leerzeichen am Anfang oder Ende.
    .do = Den Namen ändern.
