flight-lines = Flug: { $lines } { $lines ->
        [one] Streifen
        *[other] Streifen
    } zu { $n } Aufnahmen, { NUM($height_m, digits: 4) } m über Grund; Pixel { $pixel_mm } mm.

flight-overlap = Überdeckung: { PERCENT($along) } % längs, { PERCENT($across) } % quer. Verknüpfungspunkte auf { $width_m } x { $length_m } m.

flight-spacing = Basis { $base_m } m, Streifenabstand { $spacing_m } m.

flight-positions = Standardabweichungen der Positionen: { $sigma_m } m ({ $rtk ->
        [yes] RTK
        *[no] ohne RTK
    }).

flight-precision = Vorhergesagtes Sigma (RMS): X { $x }, Y { $y }, Z { $z }; c { $known ->
        [yes] { NUM($c_px, digits: 2) } px
        *[no] nicht bestimmbar
    }.

flight-determined = Alle Parameter sind durch den Entwurf bestimmt.

flight-layouts = Anordnungen von fünf Passpunkten mit 10 mm:

flight-thinned = { $n } Aufnahmen in der Mitte stehen für { $of }.

flight-predicted = Vorhersage ohne Passpunkte, { $rtk ->
        [yes] RTK
        *[no] ohne RTK
    } ({ $sigma_m } m{ $held ->
        [yes] , Hebelarm fest
        *[no] {""}
    }): Lage { $plan }, Höhe { $height }, c { $c }{ $n_lost ->
        [0] {""}
        *[other] ; nicht bestimmbar: { $lost }
    }.

flight-mend = Bestimmt durch: { $kind ->
        [tilted-grid] um 20 Grad geneigte Blickrichtungen ({ OPTION("pattern", "double-grid") } { OPTION("tilt", "20") })
        [oblique-grid] Schrägaufnahmen neben senkrechten ({ OPTION("pattern", "oblique-grid") })
        [again] ein zweites Befliegen der Streifen mit um 30 Grad nach vorn geneigtem Blick
        [turned] ein zweites Befliegen der Reihen mit um 30 Grad nach links und rechts gedrehtem Blick
        *[control] Passpunkte
    }{ $n ->
        [0] {""}
        [one] {" "}und einen Passpunkt
        *[other] {" "}und { $n } Passpunkte
    }.

flight-control_enough = Passpunkte mit { $sigma_mm } mm: { $known ->
        [no] { $n } bestimmen nicht alle Parameter.
        *[yes] { $n ->
            [0] keiner verbessert die schlechteste Höhe um 10 %.
            *[other] { $n } genügen; weitere verbessern die schlechteste Höhe um weniger als 10 %.
        }
    }

flight-camera = Kamera: { $camera } ({ $width_px } x { $height_px } px, c = { NUM($c_px, decimals: 0) } px).

flight-standing = Das Fluggerät hält für jede Aufnahme an.

flight-motion = Geschwindigkeit { NUM($speed, decimals: 1) } m/s, Takt { NUM($interval_s, decimals: 2) } s, Bewegungsunschärfe { NUM($blur_px, decimals: 2) } px bei 1/{ $exposure } s.

flight-coverage = Aufnahmen je Stelle des Gebiets: mindestens { $least }, im Median { $middle }.

flight-mission = Mission ({ $pattern }, { $vehicle }): { $photographs } Aufnahmen, { $lines } Streifen, { $way_points } Wegpunkte.

flight-ground = Pixel { $pixel } mm ({ $asked } verlangt), { $above } m über Grund; Überdeckung { $along } längs, { $across } quer.

flight-batteries = Weg { NUM($way_km, decimals: 2) } km, { $n } { $n ->
        [one] Akku
        *[other] Akkus
    } ({ $minutes } von { $usable } min), bis { NUM($farthest_m, decimals: 0) } m vom Startplatz.
