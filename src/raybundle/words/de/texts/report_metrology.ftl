report_metrology-deviations = Abweichungen von Sollkoordinaten

report_metrology-not_measured = { $n } { $n ->
        [one] Sollpunkt
        *[other] Sollpunkte
    } nicht gemessen: { LIST($names, most: 8) }.

report_metrology-fit = { $weights ->
        [yes] nach ihrer gemeinsamen Kovarianz gewichtet
        *[no] gleiche Gewichte
    }; Maßstab { $estimated ->
        [yes] { NUM($scale, digits: 8) } ± { NUM($sigma_ppm, digits: 2) } ppm
        *[no] unverändert
    }

report_metrology-axes = Achsen eingepasst auf

report_metrology-coordinate_deviation = Abweichung einer Koordinate

report_metrology-coordinate_deviation_meaning = RMS der Punkte, auf die eingepasst wurde

report_metrology-largest_deviation = größte Abweichung

report_metrology-point = Punkt { $name }

report_metrology-significant = signifikante Abweichungen

report_metrology-significant_meaning = von { $n } { $n ->
        [one] Punkt
        *[other] Punkten
    }, alle Tests zusammen

report_metrology-tolerances = Toleranzen

report_metrology-within = { $n } eingehalten

report_metrology-beyond = { $n } überschritten, { $undecided } unentschieden (ISO 14253-1, zwei Standardabweichungen)

report_metrology-fitted = eingepasst

report_metrology-tolerance = Toleranz

report_metrology-verdict = Urteil

report_metrology-verdict_of = { $verdict ->
        [within] eingehalten
        [beyond] überschritten
        *[undecided] unentschieden
    }

report_metrology-d_note = d: gemessen minus Soll, in den Achsen der Sollkoordinaten; σ enthält die Fehler der Einpassung.

report_metrology-p_note = p: Wahrscheinlichkeit einer größeren Abweichung allein durch Messfehler.

report_metrology-marked = Hervorgehoben: signifikant, alle Tests zusammen.

report_metrology-lengths = Längenmessabweichungen

report_metrology-length_errors = Abweichungen von { $n } { $n ->
        [one] Strecke
        *[other] Strecken
    } mit zwei Standardabweichungen.

report_metrology-dashed = Gestrichelt: Grenzen.

report_metrology-guideline = Abweichungen wie in VDI/VDE 2634 Blatt 1, verglichen mit A + K L, soweit angegeben.

report_metrology-no_acceptance_test = Dies ist keine Abnahmeprüfung: Zahl und Richtungen der Linien im Volumen sind nicht geprüft.
    .why = Strecken, die als Maßstabsstrecken dienten, sind keine Prüfung.

report_metrology-largest_error = größte Abweichung

report_metrology-length_error = Längenmessabweichung

report_metrology-stated_deviation = angegebene Standardabweichung

report_metrology-stated_deviation_meaning = RMS, einschließlich der bekannten Strecken

report_metrology-within_two = innerhalb zweier Standardabweichungen

report_metrology-within_two_meaning = 95 % erwartet; alle zusammen F { $f }, { P($p) }

report_metrology-allowed_errors = zulässige Abweichungen

report_metrology-kept = { $kept ->
        [yes] eingehalten
        *[no] überschritten
    }

report_metrology-over = { $n } darüber
