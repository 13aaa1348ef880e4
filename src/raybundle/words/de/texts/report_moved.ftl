report_moved-title = Verschiebungen: { LIST($epochs, most: 20) }

report_moved-subtitle = Kongruenztest über gemeinsame Punkte, im Datum der stabilen Punkte

report_moved-moved = { $n } von { $of } gemeinsamen Punkten { $n ->
        [one] hat
        *[other] haben
    } sich bewegt: { LIST($names, most: 8) } (Signifikanz { PERCENT($significance) } %).

report_moved-none_moved = Keiner von { $of } gemeinsamen Punkten hat sich bewegt (Signifikanz { PERCENT($significance) } %).

report_moved-contradiction = Die Messungen widersprechen einander; siehe unten.

report_moved-inconsistent = Stabile Punkte weichen stärker ab, als ihre Standardabweichungen erlauben (F { NUM($f) }, { P($p) }).
    .why = Standardabweichungen, die { NUM($factor) }-mal so groß sind, würden es erklären.

report_moved-faulty = Noch nicht verwenden, nach dem eigenen Bericht von { $names }; siehe unten.

report_moved-points_moved = bewegte Punkte

report_moved-of_points = von { $n }

report_moved-largest = größte Verschiebung

report_moved-at_point = Punkt { $name }

report_moved-detectable = nachweisbar ab

report_moved-power = mit einer Wahrscheinlichkeit von { PERCENT($power) } %, Median; { NUM($worst, digits: 2) } { $unit } am schlechtesten Punkt

report_moved-measurements = Messungen

report_moved-axes = Achsen

report_moved-axes_of = die von { $name }

report_moved-axes_fitted = die von { $name }, eingepasst auf { $n } { $n ->
        [one] Punkt
        *[other] Punkte
    } (RMS { NUM($rms_mm, digits: 2) } mm)

report_moved-displacements = Verschiebungen

report_moved-column_moved = bewegt

report_moved-difference = { $epoch } minus { $first }

report_moved-p_meaning = p: Wahrscheinlichkeit einer größeren Verschiebung allein durch Messfehler, für diesen Punkt allein.

report_moved-tests = Tests

report_moved-global_test = Globaltest

report_moved-all_points = alle Punkte, unter der Hypothese ohne Bewegung

report_moved-stable_points = stabile Punkte

report_moved-limit = Ein Punkt gilt als bewegt, wo seine Wahrscheinlichkeit unter { NUM($limit, digits: 2) } liegt.
    .why = Das ist die Signifikanz, geteilt durch die Zahl der Punkte.

report_moved-freedom = Der Varianzfaktor hat { $known ->
        [yes] { NUM($n) } Freiheitsgrade
        *[no] keine Unsicherheit
    }.

report_moved-scale = { $free ->
        [yes] Epochen dürfen sich im Maßstab unterscheiden: Längen sind die der ersten.
        *[no] Jede Epoche hat ihren eigenen gemessenen Maßstab.
    }

report_moved-limits = Nicht nachweisbar: eine gemeinsame Bewegung aller Punkte und eine unter der Nachweisgrenze.

report_moved-untested = nicht prüfbar

report_moved-untested_why = verschoben, aber ein falscher Bildpunkt erklärt es ebenso

report_moved-of_joint = von { $n } gemeinsam geprüften
