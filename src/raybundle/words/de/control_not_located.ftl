control_not_located = Einer von { $n } Passpunkten ist falsch; welcher, ist nicht eindeutig: { $ids }.
    .why = Alle gehen in die Ausgleichung ein (|w| { NUM($w, decimals: 1) } bei { $point }, Grenze { NUM($limit, decimals: 1) }); der falsche verfälscht das Ergebnis.
    .do = Koordinaten und Bildmessungen dieser Passpunkte prüfen oder Passpunkte ergänzen.

control_not_located-datum = Passpunkt { $point } widerspricht den übrigen Beobachtungen (|w| { NUM($w, decimals: 1) }) und geht dennoch in die Ausgleichung ein.
    .why = Ohne ihn bestimmen die Beobachtungen nicht: { datum-part }.
    .do = Seine Koordinaten und Bildmessungen prüfen und mehr Passpunkte messen.

control_not_located-unfinished = Passpunkt { $point } widerspricht den übrigen Beobachtungen (|w| { NUM($w, decimals: 1) }) und geht dennoch in die Ausgleichung ein.
    .why = Die Ausgleichung mit ihm konvergierte nicht; der Test ist nicht verlässlich.
    .do = Seine Koordinaten und Bildmessungen prüfen.
