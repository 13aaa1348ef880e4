outcome-name = { $name ->
        [accuracy] Geforderte Genauigkeit
        [asprs] ASPRS-Genauigkeitsklasse
        [tolerances] Toleranzen
        [displacements] Verschiebungen
        [limit] Grenze der Verschiebungen
        *[lengths] Längen
    }

outcome-not_kept = Nicht eingehalten: { $name ->
        [accuracy] geforderte Genauigkeit
        [asprs] ASPRS-Genauigkeitsklasse
        [tolerances] Toleranzen
        [limit] Grenze der Verschiebungen
        *[lengths] zulässige Längenmessabweichungen
    }.

outcome-lengths = { $over ->
        [0] Alle { $n } Abweichungen liegen innerhalb der Grenzen.
        *[other] { $over } von { $n } Abweichungen überschreiten die Grenzen.
    }

outcome-tolerances = { $within } innerhalb, { $beyond } außerhalb, { $undecided } unentschieden (bei zwei Standardabweichungen).

outcome-beyond = { $point }: { NUM($deviation_mm, digits: 2) } mm, Toleranz { NUM($tolerance_mm, digits: 6) } mm.

outcome-more_beyond = { $n } weitere außerhalb.

outcome-length_errors = { $n } { $independent ->
        [yes] unabhängige
        *[no] ausgeglichene
    } { $n ->
        [one] Länge
        *[other] Längen
    }: größte Abweichung { NUM($largest_mm, digits: 2) } mm ({ $start } – { $end }), RMS { NUM($rms_mm, digits: 2) } mm{ $independent ->
        [yes] .
        *[no] ; Maßstabsstrecken, kein Test.
    }

outcome-length_test = { PERCENT($within) } % innerhalb von zwei Standardabweichungen; F { NUM($f) } ({ P($p) }): { $contradicts ->
        [yes] Standardabweichungen zu klein
        *[no] vereinbar
    }.

outcome-kept = { $kept ->
        [yes] Eingehalten.
        *[no] Nicht eingehalten.
    }

outcome-no_heights = Höhe: { NUM($wanted, digits: 4) } { $wanted_unit } gefordert, nicht beurteilt: Keine Höhe wurde angegeben, Höhen sind relativ.

outcome-not_precise = { $part ->
        [horizontal] Lage
        *[vertical] Höhe
    }: { NUM($wanted, digits: 4) } { $wanted_unit } gefordert, nicht eingehalten: Standardabweichung im Median { NUM($median) } { $median_unit }.

outcome-only_control = { $part ->
        [horizontal] Lage
        *[vertical] Höhe
    }: { NUM($wanted, digits: 4) } { $wanted_unit } gefordert, nicht beurteilt: keine Kontrollpunkte.
    .why = Kreuzvalidierung der Passpunkte: { NUM($rms) } { $rms_unit } (RMS).

outcome-no_check_points = { $part ->
        [horizontal] Lage
        *[vertical] Höhe
    }: { NUM($wanted, digits: 4) } { $wanted_unit } gefordert, nicht beurteilt: keine Kontrollpunkte.

outcome-accuracy = { $part ->
        [horizontal] Lage: RMSE_H
        *[vertical] Höhe: RMSE_V
    } { NUM($found) } { $found_unit } an { $n } { $n ->
        [one] Kontrollpunkt
        *[other] Kontrollpunkten
    }, { NUM($wanted, digits: 4) } { $wanted_unit } gefordert: { $verdict ->
        [kept] eingehalten.
        [lost] nicht eingehalten.
        [few] nicht beurteilt (weniger als { $needed } Kontrollpunkte).
        *[other] keine geprüfte ASPRS-Aussage.
    }
    .why = { $verdict ->
            [unsurveyed] Die Norm verlangt Standardabweichungen der Kontrollpunkte.
            [untested] Die Norm verlangt { $needed } Kontrollpunkte.
            *[other] {""}
        }

outcome-see_report = Nicht eingehalten, siehe Bericht des Ergebnisses.
