zoom-range = { $range_mm } mm mit einer Auflösung von { $resolution_mm } mm ist kein Brennweitenbereich.
    .do = Untere und obere Grenze über 0 in dieser Reihenfolge angeben.

zoom-coefficient_count = Koeffizienten: { $n }; möglich sind 1 bis { $most }.
    .do = Die Liste korrigieren.

zoom-out_of_range = Kamera { $camera }: Die EXIF-Brennweite { NUM($focal_mm, digits: 4) } mm liegt außerhalb der kalibrierten { NUM($low_mm, digits: 4) } bis { NUM($high_mm, digits: 4) } mm.
    .do = Dort eine Einstellung kalibrieren oder Aufnahmen im kalibrierten Bereich verwenden.

zoom-too_few_settings = { $n } Einstellungen des Zoomobjektivs sind angegeben; nötig sind { $least }.
    .do = Kalibrierungen ergänzen, darunter beide Enden des Zoombereichs.

zoom-setting_given_twice = Zwei Kalibrierungen haben die EXIF-Brennweite { $focal_mm } mm.
    .do = Die Aufnahmen beider Kalibrierungen gemeinsam ausgleichen.

zoom-settings_differ = Die Kalibrierungen bei { $first_mm } und { $second_mm } mm unterscheiden sich in Format, Modell oder freien Parametern.
    .why = Freie Parameter: { LIST($first, most: 20) } und { LIST($second, most: 20) }.
    .do = Alle Einstellungen gleich kalibrieren.

zoom-held_values_differ = { LIST($parameters, most: 20) } bei { $first_mm } und { $second_mm } mm auf verschiedenen Werten festgehalten.
    .do = Diese Parameter auf gleichen Werten festhalten oder in allen Einstellungen schätzen.

zoom-lenses_differ = Die Einstellungen gehören zu verschiedenen Kameras oder Objektiven (EXIF).
    .why = Das Zoomobjektiv wird nicht in die Bibliothek aufgenommen.
    .do = Alle Einstellungen mit derselben Kamera und demselben Objektiv kalibrieren.

zoom-focal_length_unknown = Kamera { $camera }: Die EXIF-Brennweite ist unbekannt.
    .do = { OPTION("focal", "MM") } einmal je Kamera angeben.
