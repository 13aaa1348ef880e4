mark_contradicts = { $n ->
        [one] Die Bildmessung von { $point } in { $images } widerspricht den anderen{ $size_px ->
            [0] {""}
           *[other] {" "}um { NUM($size_px, digits: 2) } px
        }
       *[other] Die Bildmessungen von { $point } widersprechen sich: { $images }
    }{ $tau ->
        [0] .
       *[other] {" "}(Testgröße { NUM($tau, decimals: 1) }).
    }
    .why = { $n ->
        [one] Diese Bildmessung ging in die Ausgleichung ein und verzerrt
       *[other] Diese Bildmessungen gingen in die Ausgleichung ein und verzerren
     } Orientierungen, Kameras und Punkte.
    .do = Falsche Bildmessungen verschieben, löschen oder ausschließen: { OPTION("reject", "snooping") }.

mark_contradicts-excluded = { $n ->
        [one] Die Bildmessung von { $point } in { $images } widerspricht den anderen{ $size_px ->
            [0] {""}
           *[other] {" "}um { NUM($size_px, digits: 2) } px
        }
       *[other] Die Bildmessungen von { $point } widersprechen sich: { $images }
    }{ $tau ->
        [0] .
       *[other] {" "}(Testgröße { NUM($tau, decimals: 1) }).
    }
    .why = Das Ergebnis enthält { $n ->
        [one] diese Bildmessung
       *[other] diese Bildmessungen
     } nicht.
    .do = Die Bildmessung prüfen.
