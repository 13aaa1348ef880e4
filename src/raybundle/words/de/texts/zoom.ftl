zoom-settings = Zoomobjektiv: { $n } Einstellungen von { $low_mm } bis { $high_mm } mm, Brennweiten { $resolution_mm ->
        [0] nicht gerundet
        *[other] gerundet auf { $resolution_mm } mm
    }.

zoom-scatter = Streuung um die Kurven: das { NUM($factor, decimals: 2) }-Fache der Varianzen der Kalibrierungen.

zoom-curve = { $symbol }: Ordnung { $order } in { $variable }, größte Verbesserung { NUM($largest, digits: 2) }.

zoom-focus_unknown = Der Fokus { $of ->
        [calibration] der Kalibrierung
        *[photograph] des Fotos
    } ist nicht bekannt, und damit seine Wirkung auf die Kalibrierung.

zoom-refocused = Fokussiert auf { NUM($focus_m, digits: 6) } m, kalibriert auf { NUM($calibrated_m, digits: 6) } m: c ändert sich um { NUM($change_mm, decimals: 4) } mm (Linsengleichung).
    .why = Die Änderung der Verzeichnung ist nicht bekannt.
    .do = Einen zweiten Fokus kalibrieren.
