mark_contradicts = Die Bildmessung von { $point } in { $images } widerspricht den anderen{ $size_px ->
        [0] {""}
       *[other] {" "}um { NUM($size_px, digits: 2) } px
    }{ $tau ->
        [0] .
       *[other] {" "}(Testgröße { NUM($tau, decimals: 1) }).
    }
    .why = Sie ging in die Ausgleichung ein und verzerrt Orientierungen, Kameras und Punkte.
    .do = Falsche Bildmessungen verschieben, löschen oder ausschließen: { OPTION("reject", "snooping") }.

mark_contradicts-excluded = { $n ->
        [one] Die Bildmessung von { $point } in { $images } widerspricht den anderen{ $size_px ->
            [0] {""}
           *[other] {" "}um { NUM($size_px, digits: 2) } px
        }
       *[other] Die Bildmessungen von { $point } widersprechen sich: { $images }
    }{ $tau ->
        [0] .
       *[other] {" "}(Testgröße { NUM($tau, decimals: 1) }){ $shift ->
            [0] .
           *[other] ; Wirkung { NUM($shift, digits: 2) } { $unit }.
        }
    }
    .why = Das Ergebnis enthält { $n ->
        [one] diese Bildmessung
       *[other] diese Bildmessungen
     } nicht, der Punkt enthält ihre Wirkung nicht.
    .do = Die Bildmessung prüfen.

mark_contradicts-undecided = Die { $n } Bildmessungen von { $point } widersprechen sich: { LIST($images, most: 3) }{ $shift ->
        [0] .
       *[other] ; Wirkung bis { NUM($shift, digits: 2) } { $unit }.
    }
    .why = Welche falsch ist, ist nicht bestimmbar: alle gingen mit Standardabweichungen ein, unter denen sie übereinstimmen.
    .do = Diese Bildmessungen prüfen, die erste zuerst, oder den Punkt in einem weiteren Foto messen.
