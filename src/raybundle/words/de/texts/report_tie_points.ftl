report_tie_points-title = Verknüpfungspunkte

report_tie_points-none = Kein Objektpunkt hat einen verwendeten Strahl.

report_tie_points-arbitrary_scale = Der Maßstab ist beliebig: Nur Verhältnisse dieser Zahlen haben eine Bedeutung.

report_tie_points-ray_histogram = Zahl der Strahlen jedes Punktes.

report_tie_points-deviations = Standardabweichung der Position, √(σX² + σY² + σZ²); die letzte Säule enthält alle größeren.

report_tie_points-no_deviations = Standardabweichungen der Punkte sind unbekannt (Statistik abgeschaltet oder alle Punkte festgehalten).

report_tie_points-relief = Relief im Zuordnungsfenster mehr als verdoppelt die Standardabweichung von { PERCENT($share) } % der Punkte.

report_tie_points-roughness = Ein Verknüpfungspunkt ist das Mittel der Oberfläche in diesem Fenster (Spalte roughness in points.csv).

report_tie_points-radius = Verbesserungen einer Koordinate gegen den Abstand des Bildpunktes von der Formatmitte.

report_tie_points-sigma = Über das ganze Format ist σ einer Bildkoordinate { NUM($sigma_px, digits: 2) } px (RMS).

report_tie_points-outer_residuals = Die größte Verbesserung außen ist das { NUM($ratio, digits: 2) }-Fache der kleinsten innen.
    .do = Die mittleren Verbesserungen über dem Format auf Verzeichnung prüfen, die dem Modell fehlt.

report_tie_points-sigma_note = σ: Standardabweichung der Position.

report_tie_points-two_rays = { PERCENT($share) } % der Punkte haben 2 Strahlen: Eine falsche Zuordnung entlang der Sichtlinie bleibt verborgen.

report_tie_points-median_sigma = σ, Median

report_tie_points-rms_sigma = σ, RMS
