control_left_out = { $n } { $n ->
        [one] Passpunkt
       *[other] Passpunkte
     } aus { $name } { $n ->
        [one] widerspricht
       *[other] widersprechen
     } den übrigen und { $n ->
        [one] ist
       *[other] sind
     } ausgeschlossen: { $ids }.
    .why = Die übrigen stimmen auf { NUM($rms_mm, digits: 2) } mm (rms) überein; ausgeschlossene Punkte werden mit dem Ergebnis verglichen.
    .do = Koordinaten und Namen dieser Passpunkte prüfen.

control_left_out-unsolvable = Alle Passpunkte ({ $n }) sind ausgeschlossen: Mit ihnen gibt es keine Lösung.
    .why = Lage, Orientierung und Maßstab sind Näherungen.
    .do = Koordinaten, Namen und Messungen der Passpunkte prüfen: { LIST($ids, most: 8) }.
