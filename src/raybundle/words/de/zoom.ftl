zoom-range = { $range_mm } mm mit einer Auflösung von { $resolution_mm } mm ist kein Brennweitenbereich.
    .do = Untere und obere Grenze über 0 in dieser Reihenfolge angeben.

zoom-coefficient_count = Koeffizienten: { $n }; möglich sind 1 bis { $most }.
    .do = Die Liste berichtigen.
