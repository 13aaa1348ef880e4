groups_contradict = { $groups ->
     [one] Eine Gruppe gegebener Werte widerspricht den anderen Beobachtungen
     *[other] { $groups } Gruppen gegebener Werte widersprechen einander
    }: { $solved ->
     [yes] Mit allen ist sigma0 { $sigma0 }
     *[no] Mit allen hat der Block keine Lösung
    }.
    .why = Ohne eine dieser Gruppen passt der Block.
    .do = Einheit, Koordinatensystem und Namen dieser Gruppen prüfen.

groups_contradict-group = { $n } { $group ->
     [bars] { $n ->
     [one] Maßstabsstrecke
     *[other] Maßstabsstrecken
     }
     [positions] { $n ->
     [one] Position
     *[other] Positionen
     }
     *[control] { $n ->
     [one] Passpunkt
     *[other] Passpunkte
     }
    }: ohne { $n ->
     [one] diese Beobachtung
     *[other] diese
    } ist sigma0 { $sigma0 }.
    .do = { $unit ->
     [none] { $other ->
     [none] { "" }
     [positions] Die angegebenen Längen sind { NUM($factor, digits: 5) }-mal die ausgeglichenen: Prüfen, ob die Positionen in { $other_unit } sind.
     *[control] Die angegebenen Längen sind { NUM($factor, digits: 5) }-mal die ausgeglichenen: Prüfen, ob die Passpunkte in { $other_unit } sind.
     }
     [degrees] Prüfen, ob die Positionen geographische Länge und Breite in Grad sind.
     *[other] Die angegebenen Längen sind { NUM($factor, digits: 5) }-mal die ausgeglichenen: Prüfen, ob sie in { $unit } sind{ $other ->
     [none] { "" }
     [positions] { "" }, oder die Positionen in { $other_unit }
     *[control] { "" }, oder die Passpunkte in { $other_unit }
     }.
    }
