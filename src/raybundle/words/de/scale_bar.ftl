scale_bar-length = Maßstabsstrecke { $start } - { $end }: Die Länge ist { $length_m } m.
    .do = Eine Länge über 0 in Metern angeben.

scale_bar-sigma = Maßstabsstrecke { $start } - { $end }: Die Standardabweichung ist { $sigma_m } m.
    .do = Eine Standardabweichung über 0 in Metern angeben.

scale_bar-too_few_rays = Maßstabsstrecke { $start } - { $end }: Die Endpunkte brauchen je zwei oder mehr Strahlen.
    .do = Die Endpunkte in mehr Aufnahmen messen.

scale_bar-end_not_measured = Maßstabsstrecke { $start } - { $end }: Punkt { $point } ist in keiner Aufnahme gemessen.
    .do = Seine Bildmessungen mit { OPTION("control") } angeben oder Zielmarken mit { OPTION("target") } erkennen lassen.

scale_bar-sigma_too_large = Maßstabsstrecke { $start } - { $end }: Die Standardabweichung { $sigma_m } m ist nicht kleiner als die Länge { $length_m } m.
    .do = Beide in Metern angeben.

scale_bar-no_length = Maßstabsstrecke { $start } - { $end }: Die Enden sind ein Punkt oder haben keine Koordinaten.
    .do = Die Namen der Enden korrigieren.

scale_bar-contradict = Maßstabsstrecken widersprechen sich um den Faktor { $factor }.
    .why = { $exchanged ->
        [yes] Mit vertauschten Längen von { $first } und { $second } stimmen sie überein.
       *[no] { "" }
     }
    .do = { $exchanged ->
        [yes] Prüfen, ob die Kalibrierscheine der beiden vertauscht sind
       *[no] Längen in Metern angeben und die Namen der Enden prüfen
     }.

scale_bar-given_and_measured = Maßstabsstrecke { $bar }: angegeben { NUM($given_m, digits: 6) } m, nach { $pair ->
        [yes] { $others }
        *[no] den übrigen Strecken
    } { NUM($measured_m, digits: 6) } m.
