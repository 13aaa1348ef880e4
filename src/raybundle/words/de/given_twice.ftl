given_twice = { $kind ->
        [scale_bar] Maßstabsstrecken
       *[length] Längen
     } doppelt angegeben und einmal gezählt: { LIST($ids, most: 10) }.
    .why = Das Ergebnis ist nicht betroffen: Jede Länge zählt einmal.
    .do = Die wiederholten Zeilen löschen.
