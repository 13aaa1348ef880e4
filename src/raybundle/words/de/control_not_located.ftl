control_not_located = Einer von { $n } Passpunkten ist falsch; welcher, ist nicht eindeutig: { $ids }.
    .why = Alle nehmen teil (|w| { NUM($w, decimals: 1) } bei { $point }, Grenze { NUM($limit, decimals: 1) }); der falsche verfälscht das Ergebnis.
    .do = Ihre Koordinaten und Marken prüfen oder Passpunkte ergänzen.

control_not_located-datum = Passpunkt { $point } widerspricht den übrigen Beobachtungen (|w| { NUM($w, decimals: 1) }) und nimmt dennoch teil.
    .why = Ohne ihn bestimmen die Beobachtungen nicht: { datum-part }.
    .do = Seine Koordinaten und Marken prüfen und mehr Passpunkte messen.

control_not_located-unfinished = Passpunkt { $point } widerspricht den übrigen Beobachtungen (|w| { NUM($w, decimals: 1) }) und nimmt dennoch teil.
    .why = Die Ausgleichung mit ihm konvergierte nicht; der Test ist nicht verlässlich.
    .do = Seine Koordinaten und Marken prüfen.
