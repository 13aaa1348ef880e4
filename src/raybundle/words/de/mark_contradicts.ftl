mark_contradicts = { $n ->
        [one] Die Markierung von { $point } in { $images } widerspricht den anderen{ $size_px ->
            [0] {""}
           *[other] {" "}um { NUM($size_px, digits: 2) } px
        }
       *[other] Die Markierungen von { $point } widersprechen sich: { $images }
    }{ $tau ->
        [0] .
       *[other] {" "}(Testwert { NUM($tau, decimals: 1) }).
    }
    .why = Sie nahm teil und verzerrt Orientierungen, Kameras und Punkte.
    .do = Sie verschieben oder löschen oder solche Markierungen ausschließen: { OPTION("reject", "snooping") }.

mark_contradicts-excluded = { $n ->
        [one] Die Markierung von { $point } in { $images } widerspricht den anderen{ $size_px ->
            [0] {""}
           *[other] {" "}um { NUM($size_px, digits: 2) } px
        }
       *[other] Die Markierungen von { $point } widersprechen sich: { $images }
    }{ $tau ->
        [0] .
       *[other] {" "}(Testwert { NUM($tau, decimals: 1) }).
    }
    .why = Sie ist vom Ergebnis ausgeschlossen.
    .do = Die Markierung prüfen.
