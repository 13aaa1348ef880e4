demo-simulated = Simuliert und kalibriert: { $images } Bilder von { $n } Zielmarken, Rauschen { NUM($sigma_px, digits: 2) } px.

demo-given = Gegeben: eine Maßstabsstrecke ({ NUM($length_m, decimals: 4) } m, Sigma { $sigma_mm } mm), c = { $c_mm } mm (Fehler { PERCENT($error) } %).
    .why = Verzeichnung, Orientierungen und Koordinaten sind nicht gegeben.

demo-scale_bar = Maßstabsstrecke: { NUM($length_m, decimals: 4) } m, Standardabweichung { $sigma_mm } mm.

demo-interior = Innere Orientierung: die { $n } Parameter sind um höchstens { NUM($ratio, digits: 2) } Sigma falsch ({ $symbol }).

demo-points = { $kind ->
        [targets] Zielmarken
        *[other] Projektionszentren
    }: wahrer Fehler { NUM($rms_mm, digits: 2) } mm (RMS), angegeben { NUM($stated_mm, digits: 2) } mm.
