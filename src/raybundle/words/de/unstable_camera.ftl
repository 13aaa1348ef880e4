unstable_camera = Kamera { $camera }: Die innere Orientierung änderte sich zwischen Aufnahmen ({ $n } und { $others }).
    .why = Zwei Gruppen würden die Verbesserungen auf { PERCENT($share) } % verkleinern (c weicht um { NUM($dc_px, decimals: 1) } px ab, der Bildhauptpunkt um { NUM($dx0_px, decimals: 1) }, { NUM($dy0_px, decimals: 1) } px); die Standardabweichungen sind zu klein.
    .do = Autofokus, Zoom und Stabilisierung abschalten und neu aufnehmen oder die Gruppen getrennt kalibrieren: { OPTION("own_camera", $pattern) }.
