report_trends-title = Geschwindigkeiten

report_trends-figure = { $name }, { $first } bis { $last }: Verschiebung, Standardabweichung; Linie: { $verdict ->
        [constant] konstante Geschwindigkeit
       *[other] konstante Beschleunigung
    }.

report_trends-velocity = Geschwindigkeit

report_trends-acceleration = Beschleunigung

report_trends-motion = Bewegung

report_trends-motion_of = { $verdict ->
        [constant] gleichförmig
        [accelerated] beschleunigt
        [decelerated] verzögert
       *[irregular] ungleichförmig
    }

report_trends-note = p: der Residuen bei konstanter Geschwindigkeit; unter { NUM($limit, digits: 2) } ist die Bewegung nicht gleichförmig. a: Jahr.
