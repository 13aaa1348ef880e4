panels-no_coordinates = Punkt { $point } hat keine gegebenen Koordinaten.
    .do = Koordinaten angeben: raybundle mark control ORDNER TABELLE.csv.

panels-no_control = Kein Pass- oder Kontrollpunkt hat gegebene Koordinaten.
    .do = Koordinaten angeben: raybundle mark control ORDNER TABELLE.csv.

panels-not_placed = Nichts legt den Block im Koordinatensystem der Passpunkte fest.
    .why = Gesucht wird dort, wo die Aufnahmen jeden Punkt zeigen müssten.
    .do = { $least } Passpunkte von Hand messen und ausgleichen, oder mit Positionen der Aufnahmen orientieren: { OPTION("positions", "DATEI") }.

panels-found = Signale gefunden: { $n } von { $of } Punkten, { $marks } neue Messungen.

panels-shift = Block minus gegebene Koordinaten: X { NUM($x, digits: 3) }, Y { NUM($y, digits: 3) }, Z { NUM($z, digits: 3) } { $unit } (Median); die Punkte streuen um { NUM($spread, digits: 2) } { $unit }.

panels-missed = Punkte ohne Signal: { LIST($names, most: 6) }. { $why ->
        [not_visible] Keine Aufnahme zeigt ihre Stelle.
        [nothing] Nahe ihrer Stelle hebt sich nichts ab.
        [few_rays] Weniger als { $least } Aufnahmen zeigen ein Signal.
        [few_points] Weniger als { $least } Punkte zeigen ein Signal; eine gemeinsame Verschiebung lässt sich nicht bestätigen.
        [ambiguous] Mehrere Signale passen.
        [off] Das nächste Signal widerspricht den anderen Punkten.
        *[no_panel] Die Stelle lässt sich nicht als Kreuz, Schachbrett oder Scheibe messen.
    }
    .do = Von Hand messen oder die Koordinaten prüfen.

panels-off = { $point }: { NUM($distance, digits: 3) } { $unit } von seiner Stelle.

panels-files_not_read = Die Passpunktdateien des Projekts wurden nicht gelesen.
    .why = Gesucht wurden nur Punkte des Blocks und der Messungen.
    .do = Die Dateien zurücklegen oder Koordinaten mit raybundle mark control angeben.

panels-photographs_lost = Aufnahmen fehlen oder sind nicht lesbar: { $n }, nicht durchsucht ({ LIST($names, most: 6) }).
    .do = Die Aufnahmen zurücklegen und erneut suchen.
