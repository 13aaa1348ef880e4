given_twice = { $kind ->
        [scale_bar] Maßstabsstrecken
       *[length] Längen
     } doppelt angegeben und einmal gezählt: { LIST($ids, most: 10) }.
