choice_unfinished = Die Wahl der Parameter endete nach { $steps } Schritten; { $free } Parameter von { $cameras } { $cameras ->
        [one] Kamera
       *[other] Kameras
     } sind frei.
    .why = Einige davon sind womöglich nicht signifikant.
    .do = Die festzuhaltenden Parameter nennen: { OPTION("hold") }.
