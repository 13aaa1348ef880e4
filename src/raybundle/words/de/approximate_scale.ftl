approximate_scale = Die Maßstabsstrecken machen den Block { NUM($factor, digits: 5) }-mal so groß wie die Näherungswerte (± { NUM($std, digits: 2) } relativ).
    .why = Keine andere Beobachtung legt den Maßstab fest.
    .do = { $of ->
     [bars] Prüfen, ob die Längen der Maßstabsstrecken in { $likely } statt { $unit } sind
     *[start] Prüfen, ob die Näherungswerte in { $likely } statt { $unit } sind
    }.
