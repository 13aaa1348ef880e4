report_noise-title = Rauschen der Bildkoordinaten

report_noise-independent = Die Fehler der Bildkoordinaten gelten als unabhängig; Grund:

report_noise-smooth_errors = Fehler echter Aufnahmen sind über Hunderte von Pixeln glatt und von Bild zu Bild verschieden.
    .why = Ursachen sind Bildstabilisatoren, Fokus, Verschlüsse und Komprimierung.

report_noise-in_residuals = In den Verbesserungen sind sie kaum zu sehen; Standardabweichungen ohne sie sind zu klein.
    .why = Die Standardabweichungen dieses Berichts enthalten sie.

report_noise-estimates = Schätzwerte, Tests und kleinste aufdeckbare grobe Fehler setzen unabhängige Fehler voraus.

report_noise-common_errors = Fehler, die alle Bilder gemeinsam haben, etwa die eines Objektivmodells, sind nicht enthalten.
    .why = Kontrollpunkte, Maßstabsstrecken oder ein anderes Kameramodell zeigen sie.

report_noise-fields = glatte Fehler jedes Bildes: Standardabweichung τ eines Koeffizienten

report_noise-focus = schwankender Fokus: Verschiebung in halber Länge der längeren Seite

report_noise-share = Anteil der glatten Fehler an den Varianzen der inneren Orientierung

report_noise-floor = Sockel φ: Varianz glatter Summen von Fehlern, in Einheiten unabhängiger

report_noise-images = Bilder, davon mit hier verwendeten Verbesserungen

report_noise-mean_square = mittleres Quadrat der Verbesserungen in { $n } glatten Richtungen (1: unabhängige Fehler)

report_noise-ratio = Verhältnis zu Standardabweichungen unabhängiger Fehler: { $kind ->
        [interior] innere Orientierung
        [centres] Projektionszentren
        *[points] Objektpunkte
    }

report_noise-sigma_independent = σ, unabhängige Fehler
