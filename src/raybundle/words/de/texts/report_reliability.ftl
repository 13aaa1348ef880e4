report_reliability-title = Zuverlässigkeit

report_reliability-no_statistics = Redundanzanteile und Tests wurden nicht berechnet (die Statistik ist abgeschaltet).

report_reliability-largest = Größte Verbesserungen

report_reliability-no_redundancy_number = Keine Bildbeobachtung hat einen Redundanzanteil.

report_reliability-redundancy = Redundanzanteile r der Bildkoordinaten: Mittel { NUM($mean, decimals: 3) }, kleinster { NUM($least, decimals: 3) }.
    .why = r ist der Anteil des Fehlers einer Beobachtung, der in ihrer eigenen Verbesserung erscheint.

report_reliability-poor = { $n } { $n ->
        [one] Bildkoordinate hat
        *[other] Bildkoordinaten haben
    } r unter { $limit } ({ PERCENT($share) } %).
    .why = Ein grober Fehler geht dort fast ganz in das Ergebnis ein.

report_reliability-below_zero = { $n } { $n ->
        [one] Redundanzanteil liegt
        *[other] Redundanzanteile liegen
    } unter 0 ({ PERCENT($share) } %), bis { NUM($least, decimals: 3) }.
    .why = Das ist kein Fehler: x und y dieser Beobachtungen sind korreliert. Tests und kleinste aufdeckbare grobe Fehler verwenden die Varianz von P v, die positiv ist.

report_reliability-eigenvalues = Die Eigenwerte des 2 × 2-Blocks jedes dieser Punkte liegen in 0 … 1.
    .why = Die kleineren liegen zwischen { NUM($smaller_from, decimals: 3) } und { NUM($smaller_to, decimals: 3) }, die größeren zwischen { NUM($larger_from, decimals: 3) } und { NUM($larger_to, decimals: 3) }; ihre Summe ist r x + r y.

report_reliability-map = Mittlerer Redundanzanteil über dem Bildformat, Kamera { $camera }; rot: von anderen Beobachtungen kaum kontrolliert.

report_reliability-histogram = Redundanzanteile der Bildkoordinaten.

report_reliability-of_images = Mittlerer Redundanzanteil jedes Bildes.

report_reliability-detectable_heading = Kleinste aufdeckbare grobe Fehler

report_reliability-uncontrolled = Keine Bildbeobachtung ist kontrolliert: Grobe Fehler sind nicht aufdeckbar.

report_reliability-detectable = Kleinster aufdeckbarer grober Fehler einer Bildkoordinate: { $median } px (Median), { $most } px (95 %), { $largest } px (alle).
    .why = Er wird mit { PERCENT($power) } % Wahrscheinlichkeit auf dem Niveau { PERCENT($level) } % aufgedeckt.

report_reliability-effect = Unentdeckt verschiebt er seinen Objektpunkt um höchstens { $median } (Median), { $most } (95 %), { $largest } { $unit ->
        [units] Einheiten
        *[other] { $unit }
    } (größter Wert).

report_reliability-untested = Nicht gezählt: { $n } { $n ->
        [one] Bildkoordinate
        *[other] Bildkoordinaten
    } mit r unter { $limit }, an denen kein grober Fehler aufdeckbar ist.
    .why = Es sind Koordinaten entlang der Epipolarlinie von Punkten mit zwei Strahlen.

report_reliability-weakest_list = Die schwächsten Bildkoordinaten

report_reliability-effect_on_point = Wirkung auf den Punkt

report_reliability-weakest = Bildkoordinaten mit der größten Wirkung eines unentdeckten groben Fehlers

report_reliability-largest_note = Die { $n } größten |w|. w = v / (s √r) mit der Standardabweichung a priori, τ = w / σ₀.

report_reliability-marked = Hervorgehoben: |τ| über seinem kritischen Wert für alle Tests zusammen, { $limit }.

report_reliability-rejected = Verworfene Beobachtungen

report_reliability-none_rejected = Keine Bildbeobachtung wurde verworfen.

report_reliability-rejected_share = Verworfen: { $n } { $n ->
        [one] Bildbeobachtung
        *[other] Bildbeobachtungen
    } ({ PERCENT($share) } %).

report_reliability-rejected_list = Liste der verworfenen Beobachtungen

report_reliability-suspects = Verdächtige Beobachtungen und ihre Trennbarkeit

report_reliability-correlation_of_suspects = größte Korrelation mit einer anderen

report_reliability-suspects_note = Wenn die Testgrößen zweier verdächtiger Beobachtungen stark korrelieren, kann auch nur eine davon falsch sein.

report_reliability-single_test = |w| eines einzelnen Tests

report_reliability-all_tests = |{ $symbol }|, alle Tests zusammen

report_reliability-noncentrality = aufdeckbare Verschiebung von w

report_reliability-level_and_power = { PERCENT($level) } %, Teststärke { PERCENT($power) } %

report_reliability-critical_values = Kritische Werte
