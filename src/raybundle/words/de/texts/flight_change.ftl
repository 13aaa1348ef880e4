flight_change-planned = wie geplant

flight_change-without_rtk = ohne RTK{ $lever_arm ->
        [yes] , Hebelarm fest
        *[no] {""}
    }

flight_change-headings = wechselnde Flugrichtung

flight_change-control = { $n ->
        [1] ein Passpunkt in der Mitte
        *[5] fünf Passpunkte
    }

flight_change-across_higher = Querstreifen, { $times }-mal so hoch

flight_change-across_tilted = Querstreifen, { NUM($tilt_deg) } Grad geneigt{ $headings ->
        [yes] , wechselnde Flugrichtung
        *[no] {""}
    }{ $control ->
        [0] {""}
        [1] , ein Passpunkt
        *[5] , fünf Passpunkte
    }

flight_change-places = { $where ->
        [two_corners] zwei Ecken, Mitte der Gegenseite
        [corners] Ecken und Mitte
        [edges] Ecken, Ränder, Mitte
        [between] Ecken, Ränder, Mitte und vier dazwischen
        [one_edge] an einem Rand
        *[middle] um die Mitte
    }
