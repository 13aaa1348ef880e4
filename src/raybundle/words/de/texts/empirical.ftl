empirical-check_points = Kontrollpunkte ({ $n }): RMS { $x }, { $y } px.

empirical-fitted = { $model }: { $n } Punkte, Redundanz { $redundancy }, sigma0 { NUM($sigma0, digits: 4) }.

empirical-correlations = Korrelationen über { $limit }: { $pairs }.

empirical-suspect = { $point } prüfen: w von { $axis } = { $w } (Grenze { $limit }), Verbesserung { $residual_px } px.
