zoom-settings = Zoomobjektiv: { $n } Einstellungen von { $low_mm } bis { $high_mm } mm, Brennweiten { $resolution_mm ->
        [0] nicht gerundet
        *[other] gerundet auf { $resolution_mm } mm
    }.

zoom-scatter = Streuung um die Kurven: das { NUM($factor, decimals: 2) }-Fache der Varianzen der Kalibrierungen.

zoom-curve = { $symbol }: Ordnung { $order } in { $variable }, größte Verbesserung { NUM($largest, digits: 2) }.
