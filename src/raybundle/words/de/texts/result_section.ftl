result_section-title = Ergebnis

result_section-summary = Zusammenfassung der Ausgleichung

result_section-warnings = Warnungen und Abhilfe

result_section-limits = Grenzen dieser Zahlen

result_section-message = Meldung und Abhilfe

result_section-severities = Fehler: vor der Verwendung klären. Warnung: Ein Teil des Ergebnisses ist schwächer, als er aussieht.
    .why = Hinweis: was getan oder gewählt wurde.

result_section-median = Median { NUM($median, digits: 2) } { $unit }.

result_section-check_rms = Differenz einer Koordinate (RMS), { $n } { $n ->
        [one] Punkt
        *[other] Punkte
    }

result_section-sigma0 = σ₀ a posteriori

result_section-image_sigma = a priori 1; eine Bildkoordinate { NUM($px, digits: 2) } px{ $median ->
        [yes] {" "}(Median)
        *[no] {""}
    }

result_section-no_image_observations = a priori 1; keine Bildbeobachtungen

result_section-observations = { $n } Beobachtungen

result_section-used = { $used } verwendet, { $given } gegeben{ $rejected ->
        [0] {""}
        *[other] , { $rejected } verworfen
    }

result_section-quantities = { $kind ->
        [control] Passpunktkoordinaten
        [distance] Maßstabsstrecken
        [station] Koordinaten von Projektionszentren
        [attitude] Drehwinkel
        [coordinate] Koordinaten von Netzen
        [deviation] Abweichungen einzelner Bilder
        [parameter] beobachtete Parameter
        [relation] Beziehungen von Parametern
        [direction] Richtungen
        [zenith_angle] Zenitwinkel
        [slope_distance] Schrägstrecken
        [difference] Koordinatenunterschiede
        [plane] Abstände von Ebenen
        [line] Abstände von Geraden
        [plumb_line] Abstände von Lotrechten
        [level] Höhen über Niveaus
        *[other] { $kind }
    }

result_section-observed = { $n } beobachtet{ $held ->
        [0] {""}
        *[other] , { $held } festgehalten
    }

result_section-constraints = Datumsbedingungen

result_section-not_fixed = durch Beobachtungen nicht festgelegt

result_section-open_parts = { $which ->
        [nothing] nichts
        [position_orientation_scale] Lage, Orientierung, Maßstab
        [position_orientation] Lage, Orientierung
        [position_scale] Lage, Maßstab
        [orientation_scale] Orientierung, Maßstab
        [position] Lage
        [orientation] Orientierung
        [scale] Maßstab
        [line] Drehung um eine Gerade
        *[other] { LIST($parts, most: 7) } (t Lage, r Drehung, m Maßstab)
    }

result_section-residuals = Verbesserungen beziehen sich auf

result_section-refer_to = den { $corrected ->
        [yes] korrigierten
        *[no] gemessenen
    } Bildpunkt

result_section-convergence = konvergiert

result_section-converged = { $converged ->
        [yes] ja
        *[no] nein
    }, { $n } { $n ->
        [one] Iteration
        *[other] Iterationen
    }, { NUM($seconds, decimals: 2) } s

result_section-condition = Kondition der skalierten Normalgleichungsmatrix (genähert, aus dem kleinsten Pivot)

result_section-untestable = ohne Redundanz nicht möglich

result_section-tested = { NUM($lower, digits: 5) } … { NUM($upper, digits: 5) }: { $verdict ->
        [passed] bestanden
        [larger] nicht bestanden, Verbesserungen größer als angenommen
        *[smaller] nicht bestanden, Verbesserungen kleiner als angenommen
    }

result_section-sigma0_both = σ₀ a priori, a posteriori

result_section-square_sum = gewichtete Quadratsumme der Verbesserungen

result_section-global_test = Globaltest (χ², 95 %, zweiseitig)

result_section-critical = kritischer Wert von { $statistic ->
        [w] |w|
        *[tau] |τ|
    }, für alle Tests zusammen

result_section-at_level = { NUM($critical) } bei { PERCENT($level) } %
